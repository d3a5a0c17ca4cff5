#include "data_checks/reading_scale.h"

#include "data_checks/data_checks.h"
#include "data_checks/recorded_pendulum.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace lacuna {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr double kSameFactor = 1e-9;

/// Swings of more than a radian, which show that gravity's torque bends.
double wide(double t) { return 3.0 * multisine(t) + 0.3 * std::sin(2.0 * M_PI * 1.2 * t); }

RecordedPendulum swinging_widely(const PendulumTruth& truth = {}, std::uint64_t seed = 1) {
  RecordedPendulum rig(truth, seed);
  rig.trials = {recorded(truth, "wide.csv", wide, 6.0, seed), recorded(truth, "steps.csv", steps, 6.0, seed + 1)};
  return rig;
}

/// The readings `factor` times too large.
void misread(RecordedPendulum& rig, double factor) {
  for (Trial& trial : rig.trials) {
    trial.measured.samples *= factor;
    trial.sensor_noise[0] *= factor;
  }
}

std::optional<ReadingScale> scale_of(const RecordedPendulum& rig) {
  return reading_scale({rig.definition, *rig.model, rig.trials, rig.values});
}

class WrongFactor : public testing::TestWithParam<double> {};

TEST_P(WrongFactor, IsFoundByGravity) {
  RecordedPendulum rig = swinging_widely();
  misread(rig, GetParam());
  const std::optional<ReadingScale> scale = scale_of(rig);
  ASSERT_TRUE(scale);
  EXPECT_NEAR(scale->factor, GetParam(), kSameFactor);
  EXPECT_THAT(scale->channels, testing::ElementsAre("angle"));
}

INSTANTIATE_TEST_SUITE_P(Factors, WrongFactor,
                         testing::Values(0.25, 0.5, 2.0, 4.0, 0.1, 10.0, 1.0 / 3.0, 2.0 * std::numbers::pi,
                                         0.5 / std::numbers::pi, 180.0 / std::numbers::pi));

TEST(ReadingScaleTest, IsFoundBesideWhatTheModelLacks) {
  for (const PendulumTruth& truth :
       {PendulumTruth{.damping = 0.05, .friction = 0.03}, PendulumTruth{.inertia = 0.03}}) {
    RecordedPendulum rig = swinging_widely(truth);
    misread(rig, 0.25);
    const std::optional<ReadingScale> scale = scale_of(rig);
    ASSERT_TRUE(scale);
    EXPECT_NEAR(scale->factor, 0.25, kSameFactor);
  }
}

/// Missing effects, wrong masses and weak motors are no factor of the readings.
TEST(ReadingScaleTest, IsNotDoubtedForWhatAModelMayLack) {
  const std::vector<PendulumTruth> rigs = {{},
                                           {.inertia = 0.05},
                                           {.inertia = 0.018},
                                           {.gravity = 0.5},
                                           {.gravity = 2.0},
                                           {.damping = 0.1},
                                           {.friction = 0.1},
                                           {.backward = 0.1},
                                           {.spring = 1.0},
                                           {.cubic = 2.0},
                                           {.spring = 0.5, .cubic = -0.4},
                                           {.delay = 0.04},
                                           {.lateness = 0.03},
                                           {.limit = 0.4},
                                           {.limit = 0.5, .no_load = 6.0},
                                           {.feedback = 1.0},
                                           {.tension = 2.0, .cable_x = 0.2, .cable_z = 0.1},
                                           {.disturbance = 0.05}};
  for (std::size_t i = 0; i < rigs.size(); ++i) {
    const std::optional<ReadingScale> wide_swings = scale_of(swinging_widely(rigs[i], 10 * i + 1));
    EXPECT_FALSE(wide_swings) << "rig " << i << ": " << to_string(*wide_swings);
    const std::optional<ReadingScale> usual = scale_of(RecordedPendulum(rigs[i], 10 * i + 1));
    EXPECT_FALSE(usual) << "rig " << i << ": " << to_string(*usual);
  }
}

/// A motor of half or twice the torque moves a pendulum's small swings as much as a wrong scale: nothing is said.
TEST(ReadingScaleTest, IsNotDoubtedForAWrongGainOfTheCommand) {
  for (const double gain : {0.25, 0.5, 2.0, 4.0}) {
    RecordedPendulum rig = swinging_widely();
    for (Trial& trial : rig.trials) trial.commands.series.samples *= gain;
    EXPECT_FALSE(scale_of(rig)) << gain;
  }
}

TEST(ReadingScaleTest, SaysNothingOfSmallSwings) {
  RecordedPendulum rig;
  for (Trial& trial : rig.trials)
    trial = recorded(
        {}, trial.name, [](double t) { return 0.1 * multisine(t); }, 6.0, 3);
  misread(rig, 0.25);
  EXPECT_FALSE(scale_of(rig));
}

TEST(ReadingScaleTest, IsAmongTheDoubts) {
  RecordedPendulum rig = swinging_widely();
  misread(rig, 0.25);
  EXPECT_THAT(faults_among(data_checks({rig.definition, *rig.model, rig.trials, rig.values})),
              Contains(HasSubstr("angle: the readings agree with the known forces after they are multiplied by 4")));
}

/// A body on a vertical slider, dropped from 30 m, with heights in feet or metres.
struct Fall {
  explicit Fall(double metre, double drag = 0.0) {
    RobotSpec robot;
    robot.name = "drop";
    BodySpec body;
    body.name = "ball";
    body.mass = 0.2;
    body.inertia = {.xx = 1e-4, .yy = 1e-4, .zz = 1e-4};
    robot.bodies = {body};
    JointSpec joint;
    joint.name = "height";
    joint.kind = JointKind::slider;
    joint.child = "ball";
    joint.axis = {0.0, 0.0, 1.0};
    robot.joints = {joint};
    SensorSpec sensor;
    sensor.name = "altitude";
    sensor.element = "height";
    robot.sensors = {sensor};
    definition.structure.robot = robot;
    definition.engine.step = 0.01;
    model = compile(definition.structure, definition.engine);
    SeededNoise noise(5, 0);
    Trial trial;
    trial.name = "drop.csv";
    trial.measured.channels = {{"altitude", "m"}};
    trial.measured.times = Eigen::VectorXd::LinSpaced(201, 0.0, 2.0);
    trial.measured.samples.resize(201, 1);
    trial.sensor_noise = {1e-3 * metre};
    for (Eigen::Index i = 0; i < 201; ++i) {
      const double t = trial.measured.times(i);
      const double fallen = drag > 0.0 ? 9.81 / (drag * drag) * (drag * t + std::exp(-drag * t) - 1.0) : 4.905 * t * t;
      trial.measured.samples(i, 0) = metre * (30.0 - fallen + 1e-3 * noise.normal());
    }
    trials = {trial};
  }
  std::optional<ReadingScale> scale() const { return reading_scale({definition, *model, trials, values}); }
  ModelDefinition definition;
  std::unique_ptr<CompiledModel> model;
  std::vector<Trial> trials;
  std::vector<double> values;
};

TEST(ReadingScaleTest, FindsFeetReadAsMetresInAFall) {
  const std::optional<ReadingScale> scale = Fall(1.0 / 0.3048).scale();
  ASSERT_TRUE(scale);
  EXPECT_NEAR(scale->factor, 1.0 / 0.3048, kSameFactor);
  EXPECT_THAT(to_string(*scale), HasSubstr("feet were read as metres"));
  EXPECT_FALSE(Fall(1.0).scale());
  EXPECT_FALSE(Fall(1.0, 0.3).scale()) << "drag";
}

}  // namespace
}  // namespace lacuna
