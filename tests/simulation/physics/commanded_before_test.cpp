#include "support/robots.h"
#include "support/simulation_run.h"
#include "support/tolerances.h"

#include <lacuna/error.h>
#include <lacuna/physical_effect.h>

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna::commanded_before_test {
namespace {

constexpr double kMass = 2.0;     // kg
constexpr double kStep = 1e-3;    // s
constexpr double kForce = 6.0;    // N, from the first sample on
constexpr double kBefore = -4.0;  // N
constexpr double kEnd = 0.2;      // s

/// A mass that is pushed from t = 0 on, and was commanded something else before.
SimulationRun pushed(const RobotSpec& robot, const std::vector<double>& before, Hold hold = Hold::zero_order) {
  SimulationRun run(robot, kStep);
  run.command("motor", {0.0, 1.0}, {kForce, kForce}, hold);
  std::get<CommandSeries>(run.test.drive).before = before;
  return run;
}

/// A first-order lag of the command, as a plugin would write one.
class Lag : public PhysicalEffect {
 public:
  EffectDescription describe() const override {
    EffectDescription description;
    description.placements = {ElementKind::actuator};
    description.parameters = {{"time", "s", 0.05, 0.0, 1.0, Scale::linear, ""}};
    return description;
  }
  EffectStages stages() const override { return {.command = CommandStage::lag}; }
  int state_size(const EffectContext&) const override { return 2; }
  double command(double value, int, const StepView&, const EffectContext& context,
                 std::span<double> state) const override {
    const double before = state[1] == 0.0 ? value : state[0], steps = context.step / context.parameters[0];
    state[1] = 1.0;
    state[0] = value + (before - value) * std::exp(-steps);
    return value - (before - value) * std::expm1(-steps) / steps;
  }
};

TEST(CommandedBefore, IsWhatADelayHoldsAtTheStart) {
  for (const Hold hold : {Hold::zero_order, Hold::first_order})
    for (const double delay : {0.0, 0.012, 0.0125, 0.3}) {
      RobotSpec robot = one_joint(JointKind::slider, kMass);
      robot.actuators[0].delay = delay;
      const double late = std::min(delay, kEnd);
      EXPECT_NEAR(pushed(robot, {kBefore}, hold).last("velocity", kEnd),
                  (kBefore * late + kForce * (kEnd - late)) / kMass, kRounding)
          << delay << " s";
    }
}

TEST(CommandedBefore, IsTheFirstCommandWhereItIsNotKnown) {
  RobotSpec robot = one_joint(JointKind::slider, kMass);
  robot.actuators[0].delay = 0.05;
  for (const std::vector<double>& unknown : {std::vector<double>{}, std::vector<double>{std::nan("")}})
    EXPECT_NEAR(pushed(robot, unknown).last("velocity", kEnd), kForce * kEnd / kMass, kRounding);
}

TEST(CommandedBefore, IsWhereALagBegins) {
  constexpr double kTime = 0.05;
  const Lag lag;
  SimulationRun run = pushed(one_joint(JointKind::slider, kMass), {kBefore});
  run.place(lag, ElementKind::actuator, {0}, {kTime});
  const double share = kTime * (1.0 - std::exp(-kEnd / kTime));  // of the way that the lag is behind
  EXPECT_NEAR(run.last("velocity", kEnd), (kForce * kEnd + (kBefore - kForce) * share) / kMass, kRounding);
}

TEST(CommandedBefore, IsWhereTheErrorOfAControllerBegins) {
  RobotSpec robot = one_joint(JointKind::slider, kMass);
  robot.actuators[0].kind = ActuatorKind::pid;
  robot.actuators[0].kd = 0.5;  // acts on the error's change alone: a step gives an impulse of kd·step
  EXPECT_NEAR(pushed(robot, {kForce}).last("velocity", kStep), 0.0, kRounding);
  EXPECT_NEAR(pushed(robot, {kBefore}).last("velocity", kStep), 0.5 * (kForce - kBefore) / kMass, 1e-2);
}

TEST(CommandedBefore, MustNameEveryChannel) {
  EXPECT_THROW(pushed(one_joint(JointKind::slider, kMass), {0.0, 0.0}).last("velocity", kEnd), Error);
}

}  // namespace
}  // namespace lacuna::commanded_before_test
