#include "simulation/engine/effects.h"
#include "simulation/engine/support.h"

#include <gtest/gtest.h>

namespace lacuna::testing {
namespace {

/// Feeds sensors back to the actuators, with memory of its own.
class Feedback : public Controller {
 public:
  int state_size() const override { return 2; }
  void act(double time, std::span<const double> sensors, std::span<double> state,
           std::span<double> commands) const override {
    state[0] = 0.9 * state[0] + sensors[0];
    state[1] += 1.0;
    commands[0] = 0.4 * std::sin(8.0 * time) - 0.2 * state[0];
    commands[1] = 0.05 * std::sin(6.0 * time);
    commands[2] = 0.1 * std::cos(0.1 * state[1]);
  }
};

class SavedState : public ::testing::TestWithParam<std::string> {
 protected:
  SavedState() {
    structure_.robot = everything_for(GetParam());
    structure_.effects = {place("wear", wear_, ElementKind::joint, {0}, {0.05}),
                          place("command_lag", command_lag_, ElementKind::actuator, {1, 0}, {0.3}),
                          place("sensor_lag", sensor_lag_, ElementKind::sensor, {1, 0}, {0.2})};
    settings_.engine = GetParam();
    settings_.step = 0.002;
    settings_.substeps = 2;
    settings_.control_period = 0.005;
  }

  /// Runs to `cut`, saves, restores in another workspace and goes on; everything must equal the
  /// run that did not stop.
  void expect_continuation(const lacuna::Test& test, double cut) {
    Rig whole(structure_, settings_), parts(structure_, settings_);
    const std::vector<double> all = grid(0.0, 0.6, 0.0013), late = [&] {
      std::vector<double> times;
      for (const double time : all)
        if (time >= cut) times.push_back(time);
      return times;
    }();
    whole.options.save_final_state = parts.options.save_final_state = true;
    whole.options.imperfections = parts.options.imperfections = SensorImperfections{.seed = 3};
    whole.run(test, all);
    ASSERT_EQ(whole.result.ending, Ending::completed) << whole.result.reason;
    parts.run(test, {0.0, cut});
    ASSERT_EQ(parts.result.ending, Ending::completed) << parts.result.reason;

    const State saved = parts.result.final_state;
    parts.options.from = &saved;
    const auto other = parts.model->make_workspace();
    parts.workspace = parts.model->make_workspace();
    parts.run(test, late);
    ASSERT_EQ(parts.result.ending, Ending::completed) << parts.result.reason;
    EXPECT_EQ(parts.result.final_state, whole.result.final_state);
    EXPECT_EQ(parts.result.readings.samples,
              whole.result.readings.samples.bottomRows(parts.result.readings.samples.rows()));
  }

  EngineSettings fine() const {
    EngineSettings settings = step_of(0.001);
    settings.engine = GetParam();
    return settings;
  }

  WearingFriction wear_;
  Lag command_lag_{true}, sensor_lag_{false};
  ModelStructure structure_;
  EngineSettings settings_;
};

INSTANTIATE_TEST_SUITE_P(Engines, SavedState, ::testing::ValuesIn(engines()),
                         [](const auto& test) { return test.param; });

TEST_P(SavedState, ContinuesBitForBitUnderRecordedCommands) { expect_continuation(shake(), 0.25); }

TEST_P(SavedState, ContinuesBitForBitInClosedLoop) {
  lacuna::Test test;
  test.drive = std::make_shared<const Feedback>();
  expect_continuation(test, 0.25);
}

TEST_P(SavedState, ContinuesBitForBitFromTheVeryFirstSteps) {
  lacuna::Test test;
  test.drive = std::make_shared<const Feedback>();
  expect_continuation(test, 0.001);
}

TEST_P(SavedState, TheScenarioUsesWhatItClaimsTo) {
  Rig rig(structure_, settings_);
  rig.options.save_final_state = true;
  rig.run(shake(), grid(0.0, 0.6, 0.01));
  ASSERT_EQ(rig.result.ending, Ending::completed) << rig.result.reason;
  const auto& samples = rig.result.readings.samples;
  EXPECT_LT(samples.col(0).minCoeff(), -0.2);  // the arm swings
  if (GetParam() == "ode") {
    EXPECT_GT(samples.col(8).maxCoeff(), 0.0);                     // box_touch
    EXPECT_GT(samples.rightCols(4).leftCols(1).maxCoeff(), 20.0);  // the ground bears the box
  }
  for (const StateSection& section : rig.model->state_layout()) EXPECT_GT(section.size, 0U) << section.name;
}

TEST_P(SavedState, TurnsAreCountedAcrossASave) {
  RobotSpec robot = pendulum();
  robot.gravity.setZero();
  Rig rig(robot, fine());
  rig.options.save_final_state = true;
  rig.options.start.velocities = {20.0};
  rig.run(constant("motor", 0.0), {1.0});
  const State saved = rig.result.final_state;
  rig.options.from = &saved;
  rig.run(constant("motor", 0.0), {1.0, 2.0});
  EXPECT_NEAR(rig.result.readings.samples(0, 0), 20.0, 0.1);
  EXPECT_NEAR(rig.result.readings.samples(1, 0), 40.0, 0.4);
}

TEST_P(SavedState, OutputsBeforeTheSavedTimeAreRefused) {
  Rig rig(pendulum(), fine());
  rig.options.save_final_state = true;
  rig.run(constant("motor", 0.0), {0.5});
  const State saved = rig.result.final_state;
  rig.options.from = &saved;
  EXPECT_THROW(rig.run(constant("motor", 0.0), {0.4, 0.6}), Error);
}

TEST_P(SavedState, AStateOfAnotherSizeIsRefused) {
  Rig rig(structure_, settings_);
  const State wrong{.values = {1.0, 2.0}};
  rig.options.from = &wrong;
  EXPECT_THROW(rig.run(shake(), {0.1}), Error);
}

}  // namespace
}  // namespace lacuna::testing
