#include "plugins/built_catalog.h"
#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/simulation_run.h"
#include "support/tolerances.h"

#include <lacuna/error.h>

#include <gmock/gmock.h>

#include <cmath>

/// What effects make of readings: of a mass that flies on at a known speed, or swings.
namespace lacuna::sensor_test {
namespace {

constexpr double kSpeed = 1.5;  // m/s
constexpr double kStep = 1e-3;  // s

const PhysicalEffect& effect(const std::string& name) { return built_catalog().get<PhysicalEffect>(name); }

/// The position of the mass, read through the effect.
double read_at(const std::string& name, std::vector<double> values, double time) {
  SimulationRun run(one_joint(JointKind::slider, 1.0), kStep);
  run.place(effect(name), ElementKind::sensor, {0}, std::move(values));
  return run.from({0.0}, {kSpeed}).last("position", time);
}

TEST(SensorOffset, AddsToTheReading) { EXPECT_NEAR(read_at("sensor_offset", {-0.2}, 0.4), 0.4, kRounding); }

TEST(SensorScale, MultipliesTheReading) { EXPECT_NEAR(read_at("sensor_scale", {1.1}, 0.4), 0.66, kRounding); }

TEST(SensorDelay, ReadsWhatWasBefore) {
  EXPECT_NEAR(read_at("sensor_delay", {0.1234}, 0.4), kSpeed * (0.4 - 0.1234), kRounding);
  EXPECT_NEAR(read_at("sensor_delay", {0.1234}, 0.1), 0.0, kRounding);
}

TEST(SensorLag, FollowsARampAtItsTimeConstant) {
  constexpr double kTime = 0.05;
  for (const double time : {0.02, 0.1, 0.6})
    EXPECT_NEAR(read_at("sensor_lag", {kTime}, time), kSpeed * (time - kTime * (1.0 - std::exp(-time / kTime))),
                kRounding);
}

/// The place of an even motion tells by how much its reading is late.
void expect_lateness(const std::string& name, double value, double time) {
  const std::vector<double> values = {value};
  const std::vector<int> elements = {0};
  const double late = effect(name).lateness(time, {values, elements, ElementKind::sensor, kStep});
  EXPECT_NEAR(late, time - read_at(name, values, time) / kSpeed, 1e-5) << name;
}

TEST(Lateness, IsByHowMuchReadingsAreBehindTheMotion) {
  expect_lateness("sensor_lag", 0.05, 0.7);  // after many time constants
  expect_lateness("clock_skew", 0.01, 0.4);
  expect_lateness("clock_skew", -0.01, 0.4);
  expect_lateness("sensor_drift", 0.0, 0.4);
}

TEST(SensorSaturation, StaysAtTheEndsOfItsRange) {
  EXPECT_EQ(read_at("sensor_saturation", {-0.1, 0.5}, 0.4), 0.5);
  EXPECT_NEAR(read_at("sensor_saturation", {-0.1, 0.5}, 0.2), 0.3, kRounding);
  EXPECT_EQ(read_at("sensor_saturation", {0.25, 0.5}, 0.1), 0.25);
}

TEST(Quantisation, ReadsWholeSteps) {
  SimulationRun run(one_joint(JointKind::slider, 1.0), kStep);
  run.place(effect("quantisation"), ElementKind::sensor, {0}, {0.25});
  run.imperfections = SensorImperfections{.seed = 1};
  run.from({0.0}, {kSpeed});
  EXPECT_EQ(run.last("position", 0.4), 0.5);    // of 0.6
  EXPECT_EQ(run.last("position", 0.42), 0.75);  // of 0.63
}

TEST(EncoderEccentricity, AddsAnErrorThatRepeatsWithTheReading) {
  constexpr double kSine = 0.01, kCosine = -0.02, kPeriods = 6.0, kTrue = kSpeed * 0.4;
  EXPECT_NEAR(read_at("encoder_eccentricity", {kSine, kCosine, kPeriods}, 0.4),
              kTrue + kSine * std::sin(kPeriods * kTrue) + kCosine * std::cos(kPeriods * kTrue), kRounding);
}

TEST(SensorDrift, GrowsWithTime) { EXPECT_NEAR(read_at("sensor_drift", {0.3}, 0.4), 0.6 + 0.12, kRounding); }

TEST(SensorStages, RunInTheDocumentedOrderWhateverTheListsOrder) {
  // Scale, then offset, then range: 1.5·0.6 − 0.3 = 0.6, beyond 0.55.
  SimulationRun run(one_joint(JointKind::slider, 1.0), kStep);
  run.place(effect("sensor_saturation"), ElementKind::sensor, {0}, {-0.55, 0.55});
  run.place(effect("sensor_offset"), ElementKind::sensor, {0}, {-0.3});
  run.place(effect("sensor_scale"), ElementKind::sensor, {0}, {1.5});
  run.from({0.0}, {kSpeed});
  EXPECT_EQ(run.last("position", 0.4), 0.55);
  EXPECT_NEAR(run.last("position", 0.3), 1.5 * 0.45 - 0.3, kRounding);
}

/// A mass on a spring, which swings with a period of 2.1 s.
SimulationRun swinging() {
  SimulationRun run(one_joint(JointKind::slider, 1.0), 1e-4);
  run.structure.robot.joints[0].stiffness = 9.0;
  return run.from({0.4}, {0.0});
}

TEST(ClockSkew, ReadsWhatTheOtherClockSaysIsNow) {
  constexpr double kTime = 5.0, kRate = 3.0, kAmplitude = 0.4;
  for (const double skew : {5e-3, 2e-3, -2e-3, -5e-3}) {
    SimulationRun skewed = swinging();
    skewed.place(effect("clock_skew"), ElementKind::sensor, {0}, {skew});
    const double expected = swinging().last("position", kTime / (1.0 + skew));
    const double turned = kRate * skew * kTime;  // rad between the two moments
    EXPECT_NEAR(skewed.last("position", kTime), expected, kAmplitude * std::abs(turned * turned * turned) / 6.0 + 1e-7);
    EXPECT_GT(std::abs(skewed.last("position", kTime) - swinging().last("position", kTime)), 0.01 * kAmplitude);
  }
}

TEST(ClockSkew, OfAnEvenMotionIsExact) {
  EXPECT_NEAR(read_at("clock_skew", {0.01}, 0.4), kSpeed * 0.4 / 1.01, kRounding);
  EXPECT_NEAR(read_at("clock_skew", {-0.01}, 0.4), kSpeed * 0.4 / 0.99, kRounding);
}

TEST(ClockSkew, RefusesTouchSensors) {
  RobotSpec robot = one_joint(JointKind::slider, 1.0);
  robot.sensors[1] = make_sensor("foot", SensorKind::touch, "body");
  const std::vector<double> values = {1e-3};
  const std::vector<int> elements = {1};
  EXPECT_THAT(([&] {
                effect("clock_skew").amend(robot, {values, elements, ElementKind::sensor, kStep});
              }),
              testing::ThrowsMessage<Error>(testing::HasSubstr("sensor.foot reads contacts")));
}

}  // namespace
}  // namespace lacuna::sensor_test
