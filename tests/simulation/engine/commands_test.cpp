#include "simulation/engine/effects.h"
#include "simulation/engine/support.h"

#include <gtest/gtest.h>

namespace lacuna::testing {
namespace {

constexpr double kCommandStep = 0.001;

/// Speed of the 2 kg cart at `time` under a command series, with the motor's delay as parameter.
class CartUnderCommand : public ::testing::Test {
 protected:
  static double speed(Rig& rig, const lacuna::Test& test, double time, double delay) {
    rig.run(test, {time}, {delay});
    EXPECT_EQ(rig.result.ending, Ending::completed) << rig.result.reason;
    return rig.result.readings.samples(0, 1);
  }
  static ModelStructure delayed_cart() {
    return {.robot = cart(), .effects = {}, .parameters = {{"actuator.motor.delay", 0.0, 0.1}}};
  }
};

TEST_F(CartUnderCommand, PredictionsAreLinearInTheDelayOfAStep) {
  // A force of 2 N from 0.0200 s on: the speed at 0.1 s is (0.1 − 0.02 − delay)·2/2, whatever the
  // delay's place within an integration step.
  Rig rig(delayed_cart(), step_of(kCommandStep));
  const lacuna::Test test = series("motor", {0.0, 0.02}, {0.0, 2.0});
  for (const double delay : {0.0, 1e-7, 0.0003, 0.0005, 0.00099999, 0.001, 0.0010001, 0.0123, 0.0777})
    EXPECT_NEAR(speed(rig, test, 0.1, delay), 0.08 - delay, 1e-10) << delay;
}

TEST_F(CartUnderCommand, CommandsBetweenStepsCountWithTheirShare) {
  Rig rig(delayed_cart(), step_of(kCommandStep));
  const lacuna::Test pulse = series("motor", {0.0, 0.01033, 0.01077}, {0.0, 100.0, 0.0});
  EXPECT_NEAR(speed(rig, pulse, 0.05, 0.0), 0.00044 * 100.0 / 2.0, 1e-10);
}

TEST_F(CartUnderCommand, FirstOrderHoldIntegratesARamp) {
  Rig rig(delayed_cart(), step_of(kCommandStep));
  const lacuna::Test ramp = series("motor", {0.0, 0.1}, {0.0, 4.0}, Hold::first_order);
  for (const double delay : {0.0, 0.0004, 0.03})
    EXPECT_NEAR(speed(rig, ramp, 0.1, delay), 0.5 * 40.0 * (0.1 - delay) * (0.1 - delay) / 2.0, 1e-10) << delay;
  const lacuna::Test held = series("motor", {0.0, 0.1}, {0.0, 4.0});
  EXPECT_NEAR(speed(rig, held, 0.1, 0.0), 0.0, 1e-12);
}

TEST_F(CartUnderCommand, BeforeTheFirstAndAfterTheLastSampleTheNearestCounts) {
  Rig rig(delayed_cart(), step_of(kCommandStep));
  const lacuna::Test test = series("motor", {0.03, 0.06}, {2.0, -2.0}, Hold::first_order);
  EXPECT_NEAR(speed(rig, test, 0.09, 0.0), (0.03 * 2.0 + 0.0 - 0.03 * 2.0) / 2.0, 1e-10);
  EXPECT_NEAR(speed(rig, test, 0.03, 0.0), 0.03, 1e-10);
}

TEST_F(CartUnderCommand, StepRoundingDelaysByWholeSteps) {
  EngineSettings settings = step_of(0.01);
  settings.delay_rounding = DelayRounding::step;
  settings.substeps = 4;
  Rig rig(delayed_cart(), settings);
  const lacuna::Test test = series("motor", {0.0, 0.02}, {0.0, 2.0});
  EXPECT_NEAR(speed(rig, test, 0.1, 0.014), 0.07, 1e-10);
  EXPECT_NEAR(speed(rig, test, 0.1, 0.016), 0.06, 1e-10);
}

TEST_F(CartUnderCommand, GainOffsetAndRangeApplyInThisOrder) {
  RobotSpec robot = cart();
  robot.actuators[0].gain = 3.0;
  robot.actuators[0].offset = 1.0;
  robot.actuators[0].command_upper = 5.0;
  robot.actuators[0].command_lower = -4.0;
  Rig rig(robot, step_of(kCommandStep));
  const auto force = [&](double command) { return rig.run(constant("motor", command), {0.01}).readings.samples(0, 2); };
  EXPECT_DOUBLE_EQ(force(1.0), 4.0);
  EXPECT_DOUBLE_EQ(force(2.0), 5.0);
  EXPECT_DOUBLE_EQ(force(-2.0), -4.0);
}

TEST_F(CartUnderCommand, CommandEffectsRunInTheOrderOfTheirStages) {
  // gain before offset, although the names and the list say otherwise
  const CommandArithmetic add(CommandStage::offset, false), multiply(CommandStage::gain, true);
  Rig rig(ModelStructure{.robot = cart(),
                         .effects = {place("a_adds", add, ElementKind::actuator, {0}, {5.0}),
                                     place("b_multiplies", multiply, ElementKind::actuator, {0}, {2.0})},
                         .parameters = {}},
          step_of(kCommandStep));
  EXPECT_DOUBLE_EQ(rig.run(constant("motor", 1.0), {0.01}).readings.samples(0, 2), 7.0);
}

/// Pushes with the time at which it acts.
class Clockwork : public Controller {
 public:
  void act(double time, std::span<const double>, std::span<double>, std::span<double> commands) const override {
    commands[0] = 1.0 + time;
  }
};

TEST_F(CartUnderCommand, ControllersActOnceAControlPeriod) {
  EngineSettings settings = step_of(kCommandStep);
  settings.control_period = 0.0025;  // no multiple of the step: it acts at the first step end after
  Rig rig(cart(), settings);
  rig.options.record_commands = true;
  lacuna::Test test;
  test.drive = std::make_shared<const Clockwork>();
  rig.run(test, grid(0.0, 0.008, 0.001));
  const std::vector<double> expected{0.0, 0.0, 0.0, 0.003, 0.003, 0.005, 0.005, 0.005, 0.005};
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(rig.result.commands.samples(static_cast<Eigen::Index>(i), 0), 1.0 + expected[i], 1e-12) << i;
}

TEST_F(CartUnderCommand, AControllersDelayedCommandIsTheReplayedOne) {
  // What a controller sent, replayed as a recording, gives the same motion under any delay.
  Rig closed(delayed_cart(), step_of(kCommandStep)), replay(delayed_cart(), step_of(kCommandStep));
  closed.options.record_commands = true;
  lacuna::Test test;
  test.drive = std::make_shared<const Clockwork>();
  const std::vector<double> times = grid(0.0, 0.1, kCommandStep);
  for (const double delay : {0.0, 0.0004, 0.003, 0.0137}) {
    closed.run(test, times, {delay});
    CommandSeries sent;
    sent.series = closed.result.commands;
    replay.run(lacuna::Test{.drive = sent, .duration = 0.1, .start = {}}, times, {delay});
    EXPECT_LT((closed.result.readings.samples - replay.result.readings.samples).cwiseAbs().maxCoeff(), 1e-9) << delay;
  }
}

}  // namespace
}  // namespace lacuna::testing
