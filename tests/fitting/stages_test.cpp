#include "fitting/stages.h"

#include "fitting/made_problem.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna::stages_test {
namespace {

using namespace lacuna::analytic;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// The stages of a fit to a spring's recording of `duration` s.
struct Planned {
  explicit Planned(const FitSection& options, double duration = 5.0, const RobotSpec& robot = one_joint_robot())
      : predictor(model, {spring_trial(kNoise, 1, duration)}, {1}),
        states(robot, predictor, {{"angle", "rad", kNoise, ""}}) {
    for (const PlannedStage& stage : plan_stages(options, predictor, states, notes)) {
      names.push_back(stage.name);
      lengths.push_back(stage.length);
      if (stage.automatic) names.back() += " (automatic)";
    }
  }
  OneJointModel model{spring};
  TrialPredictor predictor;
  StartStates states;
  std::vector<std::string> names, notes;
  std::vector<double> lengths;
};

FitSection with_horizon(const std::string& horizon) {
  FitSection options;
  options.horizon = horizon;
  return options;
}

TEST(PlanStages, GrowFromShortSegmentsToWholeTrials) {
  const Planned planned({});
  EXPECT_THAT(planned.names, ElementsAre("segments of 0.1 s", "segments of 0.5 s", "free run"));
  EXPECT_THAT(planned.lengths, ElementsAre(0.1, 0.5, 0.0));
  EXPECT_THAT(planned.notes, testing::IsEmpty());
}

TEST(PlanStages, EndAtTheHorizon) {
  const Planned planned(with_horizon("0.3"));
  EXPECT_THAT(planned.names, ElementsAre("segments of 0.1 s", "segments of 0.3 s"));
  EXPECT_THAT(planned.lengths, ElementsAre(0.1, 0.3));
  EXPECT_THAT(Planned(with_horizon("auto")).names,
              ElementsAre("segments of 0.1 s", "segments of 0.5 s", "automatic horizon (automatic)"));
}

TEST(PlanStages, HaveNoSegmentsAsLongAsTheLongestTrial) {
  EXPECT_THAT(Planned({}, 0.4).names, ElementsAre("segments of 0.1 s", "free run"));
}

TEST(PlanStages, AreOneOfAFreeRun) {
  FitSection options = with_horizon("0.3");
  options.method = "free_run";
  EXPECT_THAT(Planned(options).names, ElementsAre("free run"));
}

TEST(PlanStages, AreAFreeRunWhereNoStateInsideATrialIsKnown) {
  RobotSpec robot = one_joint_robot();
  robot.sensors[0].kind = SensorKind::joint_velocity;
  const Planned planned({}, 5.0, robot);
  EXPECT_THAT(planned.names, ElementsAre("free run"));
  EXPECT_THAT(planned.notes, ElementsAre(HasSubstr("fitted by free run alone, because initial states inside a trial")));
}

TEST(PlanStages, RefuseWhatIsNoMethodOrHorizon) {
  for (const char* horizon : {"soon", "-1", "2 s", ""})
    EXPECT_THAT([&] { Planned planned(with_horizon(horizon)); },
                ThrowsMessage<Error>(HasSubstr("write \"whole\", \"auto\" or seconds")))
        << horizon;
  FitSection options;
  options.method = "guess";
  EXPECT_THAT([&] { Planned planned(options); }, ThrowsMessage<Error>(HasSubstr("fit.method is \"guess\"")));
}

/// s, of q'' = −b q', recorded at 200 Hz.
double horizon_of(double damping, double growth = kTolerableGrowth) {
  const OneJointModel model([](std::span<const double> p, double, double v, double) { return -p[0] * v; });
  const Trial trial = record(model, {damping}, regular_times(1001, 200.0), {}, {{0.3}, {0.5}}, kNoise, 2);
  const TrialPredictor predictor(model, {trial}, {1});
  const StartStates states(one_joint_robot(), predictor, {{"angle", "rad", kNoise, ""}});
  return automatic_horizon(predictor, states, {damping}, kHead, growth);
}

/// Without damping it is the line through N = 11 readings of 50 ms that leaves them: its variance is
/// σ²(1/N + (t − 25 ms)²/Sxx) with Sxx = 5 ms² N (N² − 1)/12.
TEST(AutomaticHorizon, IsWhereTheUncertaintyOfTheStartReachesTwiceTheNoise) {
  const double sxx = 25e-6 * 11.0 * 120.0 / 12.0;
  const auto expected = [&](double growth) { return 0.025 + std::sqrt((growth * growth - 1.0 / 11.0) * sxx); };
  EXPECT_NEAR(horizon_of(0.0), expected(2.0), 0.15 * expected(2.0));
  EXPECT_NEAR(horizon_of(0.0, 8.0), expected(8.0), 0.15 * expected(8.0));
}

TEST(AutomaticHorizon, HasNoLimitWhereTheStartIsForgotten) { EXPECT_TRUE(std::isinf(horizon_of(50.0))); }

}  // namespace
}  // namespace lacuna::stages_test
