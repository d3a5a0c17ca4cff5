#include "experiment_design/propose_test.h"

#include "experiment_design/candidate_pendulum.h"
#include "experiment_design/test_line.h"
#include "foundation/processes/interrupt.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

constexpr double kKnownTo = 0.05;  // of a value, its deviation

/// A recording of this length (s) whose commands lie between these, N·m.
Trial commanded(double duration, double least, double most) {
  Trial trial;
  const auto samples = static_cast<Eigen::Index>(std::lround(duration / 0.01)) + 1;
  trial.measured.times = Eigen::VectorXd::LinSpaced(samples, 0.0, duration);
  trial.commands.series = {{{"motor", "N*m"}}, trial.measured.times, Eigen::VectorXd::LinSpaced(samples, least, most)};
  return trial;
}

/// The pendulum with a spring or without, whose motor and recordings decide about the test between them.
class ProposeTest : public testing::Test {
 protected:
  /// With a row and a column for the timestamp offset of the commands.
  static FittedCandidate fitted(const std::string& name, const Pendulum& pendulum) {
    const auto size = static_cast<Eigen::Index>(pendulum.values.size());
    FittedCandidate candidate{name, pendulum.definition, pendulum.values, std::nullopt,
                              Eigen::MatrixXd::Zero(size + 1, size + 1)};
    for (Eigen::Index i = 0; i < size; ++i)
      candidate.covariance(i, i) = std::pow(kKnownTo * pendulum.values[static_cast<std::size_t>(i)], 2);
    candidate.covariance(size, size) = 0.16;
    return candidate;
  }
  static TestConditions conditions(double) { return {{}, {}, {{"angle", "rad", kReadingNoise, "declared"}}}; }

  std::optional<NextTest> proposed(const FittedCandidate& one, const FittedCandidate& other,
                                   const std::vector<Trial>& trials,
                                   const ConditionsAt& conditions_at = conditions) const {
    return propose_test(built_catalog(), rigid_.experiment, one, other, trials, conditions_at, 1, work_);
  }
  std::optional<NextTest> proposed(const std::vector<Trial>& trials) const {
    return proposed(fitted("rigid", rigid_), fitted("sprung", sprung_), trials);
  }

  Work work_ = {1};
  Pendulum rigid_{""}, sprung_{R"({ effect = "joint_spring", where = "joint.hinge", start = { stiffness = 0.2 } })"};
};

TEST_F(ProposeTest, StaysWithinTheLengthAndTheCommandsOfTheRecordings) {
  rigid_.definition.structure.robot.actuators.front().force_limit = kInfinity;
  const std::optional<NextTest> test = proposed({commanded(3.0, -0.1, 0.1), commanded(2.0, 0.0, 0.25)});
  ASSERT_TRUE(test);
  EXPECT_EQ(test->candidates, (std::array<std::string, 2>{"rigid", "sprung"}));
  EXPECT_GT(test->nats, kDecisiveNats);
  EXPECT_EQ(test->evaluations, 24);
  TestSpace space = test_space(rigid_.definition.structure.robot, rigid_.definition.engine, 3.0);
  space.lower = {-0.1};
  space.upper = {0.25};
  EXPECT_EQ(parse_test_line(space, test->line).duration, 3.0) << "within the limits, else it throws";
}

TEST_F(ProposeTest, LastsTenSecondsAtTheMost) {
  const std::optional<NextTest> test = proposed({commanded(30.0, -0.1, 0.1)});
  ASSERT_TRUE(test);
  const TestSpace space = test_space(rigid_.definition.structure.robot, rigid_.definition.engine, 10.0);
  EXPECT_EQ(parse_test_line(space, test->line).duration, 10.0);
}

TEST_F(ProposeTest, AsksForTheConditionsAtTheIntervalOfItsReadings) {
  rigid_.definition.engine.control_period = 0.02;
  double asked = 0.0;
  const auto conditions_at = [&](double period) {
    asked = period;
    return conditions(period);
  };
  EXPECT_TRUE(proposed(fitted("rigid", rigid_), fitted("sprung", sprung_), {commanded(1.0, -0.1, 0.1)}, conditions_at));
  EXPECT_EQ(asked, 0.02);
}

/// What no reading knows is no difference between the two.
TEST_F(ProposeTest, IsWorthNothingWhereNoSensorsNoiseIsKnown) {
  const auto unknown = [](double) { return TestConditions{}; };
  EXPECT_FALSE(proposed(fitted("rigid", rigid_), fitted("sprung", sprung_), {commanded(1.0, -0.1, 0.1)}, unknown));
}

TEST_F(ProposeTest, IsNothingWhereNeitherMotorNorRecordingLimitsTheCommand) {
  rigid_.definition.structure.robot.actuators.front().force_limit = kInfinity;
  Trial trial = commanded(1.0, -0.1, 0.1);
  trial.commands = {};
  EXPECT_FALSE(proposed({trial}));
}

TEST_F(ProposeTest, IsNothingWhereTheRobotHasNoActuator) {
  for (Pendulum* pendulum : {&rigid_, &sprung_}) pendulum->definition.structure.robot.actuators.clear();
  Trial trial = commanded(1.0, -0.1, 0.1);
  trial.commands = {};
  EXPECT_FALSE(proposed({trial}));
}

/// A late command looks a little like a softer spring.
TEST_F(ProposeTest, LetsTheTimestampOffsetExplainADifferenceOnlyWhereItWasFitted) {
  const std::vector<Trial> trials = {commanded(2.0, -0.3, 0.3)};
  FittedCandidate rigid = fitted("rigid", rigid_), sprung = fitted("sprung", sprung_);
  const std::optional<NextTest> known = proposed(rigid, sprung, trials);
  rigid.timing = sprung.timing = -0.1;
  const std::optional<NextTest> refitted = proposed(rigid, sprung, trials);
  ASSERT_TRUE(known && refitted);
  EXPECT_LT(refitted->nats, known->nats);
  const auto values = static_cast<Eigen::Index>(rigid_.values.size());
  rigid.timing = sprung.timing = std::nullopt;
  rigid.covariance.conservativeResize(values, values);
  EXPECT_EQ(proposed(rigid, sprung, trials)->nats, known->nats) << "the offset's row does not matter";
}

TEST_F(ProposeTest, EndsWhereItsTimeIsUp) {
  TimeLimit limit(0.0, "0 s");
  work_.stop = Stop(limit);
  EXPECT_THROW(proposed({commanded(1.0, -0.1, 0.1)}), TimeIsUp);
}

/// The candidates differ in the weight of one of two setups alone; each setup more is worth eight tests more.
TEST(ProposeTestInSetups, TriesTheSetupsOfTheRecordings) {
  const PendulumWithLoads one(0.5), other(0.7);
  const auto size = static_cast<Eigen::Index>(one.values.size());
  const auto fitted = [&](const std::string& name, const PendulumWithLoads& pendulum) {
    return FittedCandidate{name, pendulum.definition, pendulum.values, std::nullopt,
                           Eigen::MatrixXd::Identity(size, size) * 1e-18};
  };
  const std::optional<NextTest> test = propose_test(
      built_catalog(), one.experiment, fitted("one", one), fitted("other", other), {commanded(2.0, -0.3, 0.3)},
      [](double) {
        return TestConditions{{}, {}, {{"angle", "rad", kReadingNoise, "declared"}}};
      },
      1, {1});
  ASSERT_TRUE(test && test->setup);
  EXPECT_EQ(test->setup->name(), "steps");
  EXPECT_EQ(test->evaluations, 24 + 8);
}

}  // namespace
}  // namespace lacuna
