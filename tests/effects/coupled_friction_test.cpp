#include "plugins/built_catalog.h"
#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/simulation_run.h"

#include <lacuna/error.h>

#include <gmock/gmock.h>

#include <cmath>

/// Two sliders that nothing but the friction couples.
namespace lacuna::coupled_friction_test {
namespace {

constexpr double kFirst = 0.8, kSecond = 0.5;  // kg

const PhysicalEffect& effect() { return built_catalog().get<PhysicalEffect>("coupled_friction"); }

RobotSpec two_sliders() {
  RobotSpec robot = one_joint(JointKind::slider, kFirst);
  robot.bodies.push_back(plain_body("other", kSecond, 1.0));
  robot.joints.push_back(robot.joints[0]);
  robot.joints[1].name = "second";
  robot.joints[1].child = "other";
  robot.sensors.push_back(make_sensor("position2", SensorKind::joint_position, "second"));
  robot.sensors.push_back(make_sensor("velocity2", SensorKind::joint_velocity, "second"));
  return robot;
}

SimulationRun with(std::vector<double> values, double step) {
  SimulationRun run(two_sliders(), step);
  run.place(effect(), ElementKind::joint, {0, 1}, std::move(values));
  return run;
}

TEST(CoupledFriction, AgreesWithAnIndependentIntegration) {
  constexpr double kViscous = 0.3, kDry = 0.6, kVelocity = 0.2, kRatio = -0.6, kEnd = 1.5;
  const Derivative motion = [](const ReferenceState& x, ReferenceState& dx, double time) {
    const double r = x[2] + kRatio * x[3], f = kViscous * r + kDry * std::tanh(r / kVelocity);
    dx = {x[2], x[3], (2.0 - 2.5 * time - f) / kFirst, -kRatio * f / kSecond};
  };
  const ReferenceState expected = integrate_smooth(motion, {0.0, 0.0, 0.5, -1.0}, {0.0, kEnd}).back();
  const auto error = [&](const char* channel, std::size_t state, double step) {
    SimulationRun run = with({kViscous, kDry, kVelocity, kRatio}, step);
    run.command("motor", {0.0, 2.0}, {2.0, -3.0}, Hold::first_order).from({0.0, 0.0}, {0.5, -1.0});
    return run.last(channel, kEnd) - expected[state];
  };
  for (const auto& [channel, state] : {std::pair{"position", 0U}, std::pair{"position2", 1U}}) {
    EXPECT_LT(std::abs(error(channel, state, 1e-3)), 1e-5) << channel;
    EXPECT_NEAR(error(channel, state, 1e-3) / error(channel, state, 5e-4), 4.0, 0.4) << channel;
  }
}

/// Impulses on both joints, one `ratio` times the other, until the coupled motion has stopped.
TEST(CoupledFriction, StopsTheCoupledMotionAndLeavesTheOther) {
  constexpr double kRatio = 1.5, kFaster = 1.0, kSlower = -0.3;
  const double impulse = (kFaster + kRatio * kSlower) / (1.0 / kFirst + kRatio * kRatio / kSecond);
  const auto error = [&](double step) {
    SimulationRun run = with({0.0, 0.5, 0.01, kRatio}, step);
    run.from({0.0, 0.0}, {kFaster, kSlower});
    const TimeSeries readings = run.run({0.0, 2.0}).readings;
    const double first = column(readings, "velocity")(1), second = column(readings, "velocity2")(1);
    EXPECT_NEAR(first + kRatio * second, 0.0, 1e-6);
    return std::abs(first - (kFaster - impulse / kFirst));
  };
  EXPECT_LT(error(1e-3), 1e-3);
  EXPECT_LT(error(2.5e-4), 1e-4);
}

/// However steep it is for the step, and in both engines. A step that does not resolve it splits its impulses between
/// the joints inexactly, which costs or brings a little energy.
TEST(CoupledFriction, IsStableHoweverSteepItIs) {
  for (const char* engine : {"articulated", "ode"})
    for (const double velocity : {1e-1, 1e-3, 1e-6}) {
      SimulationRun run = with({20.0, 2.0, velocity, -1.0}, 1e-2);
      run.engine.engine = engine;
      run.from({0.0, 0.0}, {1.0, -0.4});
      const TimeSeries readings = run.run(evenly_spaced(1.0, 100)).readings;
      const Eigen::ArrayXd first = column(readings, "velocity").array(), second = column(readings, "velocity2").array();
      const Eigen::ArrayXd energy = 0.5 * (kFirst * first.square() + kSecond * second.square());
      for (Eigen::Index i = 1; i < energy.size(); ++i)
        EXPECT_LE(energy(i), energy(i - 1) + 0.01 * energy(0)) << engine << ' ' << velocity << ' ' << i;
      EXPECT_NEAR(first.tail(1)(0), second.tail(1)(0), 1e-3) << engine << ' ' << velocity;
    }
}

TEST(CoupledFriction, RefusesOtherNumbersOfJoints) {
  RobotSpec robot = two_sliders();
  const std::vector<double> values = {0.0, 0.0, 0.01, 1.0};
  for (const std::vector<int>& joints : {std::vector<int>{0}, std::vector<int>{0, 1, 1}})
    EXPECT_THAT(([&] {
                  effect().amend(robot, {values, joints, ElementKind::joint, 1e-3});
                }),
                testing::ThrowsMessage<Error>(testing::HasSubstr("acts between two joints")));
}

}  // namespace
}  // namespace lacuna::coupled_friction_test
