#include "data_checks/wrong_controllers.h"

#include "measurement/trials/recorded_controller.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lacuna {
namespace {

constexpr double kGain = 2.0;  // N·m/rad

/// Ten periods of a reading, which a controller of gain 2 towards zero answered, declared with some gain.
Trial controlled(double declared) {
  constexpr Eigen::Index kSamples = 200;
  Trial trial;
  trial.name = "run.csv";
  trial.measured.channels = {{"angle", "rad"}};
  trial.measured.times = Eigen::VectorXd::LinSpaced(kSamples, 0.0, 1.99);
  trial.measured.samples.resize(kSamples, 1);
  for (Eigen::Index i = 0; i < kSamples; ++i)
    trial.measured.samples(i, 0) = std::sin(2.0 * std::numbers::pi * static_cast<double>(i) / 20.0);
  trial.commands.series = trial.measured;
  trial.commands.series.channels = {{"motor", "N*m"}};
  trial.commands.series.samples = -kGain * trial.measured.samples;
  TimeSeries references = trial.measured;
  references.samples.setZero();
  trial.controller =
      std::make_shared<RecordedController>(std::vector<ControlLaw>{{.proportional = declared}},
                                           RecordedSignals{references, trial.commands, {0}, trial.measured});
  return trial;
}

TEST(WrongControllers, AreNoneWhereTheLawMakesTheRecordedCommands) {
  EXPECT_TRUE(wrong_controllers({controlled(kGain)}).empty());
}

/// Half the gain leaves half of every command.
TEST(WrongControllers, SayHowFarOffTheirCommandsAre) {
  const std::vector<WrongController> wrong = wrong_controllers({controlled(kGain), controlled(0.5 * kGain)});
  ASSERT_EQ(wrong.size(), 1U);
  EXPECT_EQ(wrong[0].trial, "run.csv");
  EXPECT_EQ(wrong[0].actuator, "motor");
  EXPECT_NEAR(wrong[0].off, 0.5, 1e-9);
}

TEST(WrongControllers, AreToleratedUpToATenth) {
  EXPECT_TRUE(wrong_controllers({controlled(0.92 * kGain)}).empty());
  EXPECT_EQ(wrong_controllers({controlled(0.88 * kGain)}).size(), 1U);
}

TEST(WrongControllers, AreNotLookedForInWhatIsHeldOut) {
  std::vector<Trial> trials = {controlled(-kGain)};
  trials[0].held_out = true;
  EXPECT_TRUE(wrong_controllers(trials).empty());
}

/// A reading that is missing tells nothing of the law.
TEST(WrongControllers, DoNotCountMissingReadings) {
  Trial trial = controlled(kGain);
  TimeSeries gap = trial.measured;
  gap.samples(50, 0) = std::nan("");
  TimeSeries references = trial.measured;
  references.samples.setZero();
  trial.controller = std::make_shared<RecordedController>(std::vector<ControlLaw>{{.proportional = kGain}},
                                                          RecordedSignals{references, trial.commands, {0}, gap});
  EXPECT_TRUE(wrong_controllers({trial}).empty());
}

}  // namespace
}  // namespace lacuna
