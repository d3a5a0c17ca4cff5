#include "evaluation/prediction/step_count.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A trial from 100 s on, so long.
Trial trial_of(double duration) {
  Trial trial;
  trial.name = "sine.csv";
  trial.measured.times = Eigen::Vector2d(100.0, 100.0 + duration);
  return trial;
}

class StepCount : public testing::Test {
 protected:
  StepCount() { experiment_.locations = {{"engine.step", {"rig.toml", 30, 8}}}; }
  std::string complaint(double duration, bool takes_tests = false) const {
    try {
      check_step_count(experiment_, {trial_of(1.0), trial_of(duration)}, takes_tests);
    } catch (const BadInput& bad) {
      return bad.what();
    }
    return "";
  }
  Experiment experiment_;
};

TEST_F(StepCount, RefusesAStepThatNobodyCanWaitForWithTheCountAndItsPlace) {
  experiment_.engine.step = 1e-9;
  experiment_.engine.substeps = 4;
  EXPECT_THAT(complaint(3.0),
              AllOf(HasSubstr("rig.toml:30:8: engine.step: 1.00 ns in 4 substeps makes 1.2e+10"),
                    HasSubstr("of sine.csv (3.00 s)"), HasSubstr("more than 1e+08"), HasSubstr("engine.step = 1e-06")));
}

TEST_F(StepCount, CountsTheTestsOfATargetThatTakesThem) {
  experiment_.test.duration = 1e6;
  EXPECT_EQ(complaint(3.0), "");
  EXPECT_THAT(complaint(3.0, true), HasSubstr("of a test"));
}

TEST_F(StepCount, CountsTheFinerStepsOfASimulatedTarget) {
  experiment_.engine.step = 1e-6;
  EXPECT_EQ(complaint(3.0), "");
  experiment_.target.simulated.substeps = 100;
  EXPECT_THAT(complaint(3.0), HasSubstr("makes 3e+08"));
}

TEST_F(StepCount, LeavesAnHourAtAKilohertzAlone) {
  experiment_.engine.substeps = 16;
  EXPECT_EQ(complaint(3600.0), "");
}

}  // namespace
}  // namespace lacuna
