#include "diagnosis/refit/timing.h"

#include "diagnosis/pendulum_rounds.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

constexpr double kInterval = 0.01;  ///< s, between commands of the recordings

/// Rounds of a pendulum whose commands act later than was recorded.
class TimingOfCommands : public PendulumRounds {
 protected:
  Round round_of(const Contender& contender, double delay) {
    return PendulumRounds::round_of(contender, {.inertia = 0.03, .damping = 0.02, .delay = delay},
                                    {"coulomb_friction"});
  }

  Contender with_delay(double delay) {
    std::vector<double> values = model_.values;
    values.push_back(delay);
    return with_effects(model_, {{"late", "command_delay", {"actuator.motor"}, {}, {}}}, values, built_catalog());
  }
};

TEST_F(TimingOfCommands, IsFoundBesideTheValuesAndLeavesNothingMissing) {
  const Round round = round_of(model_, 0.4 * kInterval);
  ASSERT_TRUE(round.base.timing);
  EXPECT_NEAR(*round.base.timing, 0.4, 0.08) << "half an integration step is a sixteenth";
  EXPECT_EQ(round.fit.timing, round.base.timing);
  BaseSolution as_recorded = round.base;
  as_recorded.timing = 0.0;
  linearise_timing(model_, round.bins, 1, as_recorded);
  EXPECT_LT(round.base.residual, 0.8 * as_recorded.residual);
  EXPECT_GT(round.screening.p, 0.05);
}

TEST_F(TimingOfCommands, GoesNoFurtherThanAnInterval) {
  const Round round = round_of(model_, 2.0 * kInterval);
  ASSERT_TRUE(round.base.timing);
  EXPECT_EQ(*round.base.timing, 1.0);
  EXPECT_TRUE(round.fit.at_bound.back());
}

TEST_F(TimingOfCommands, IsLeftOutWhereTheModelHoldsADelay) {
  const Round round = round_of(with_delay(1.4 * kInterval), 2.0 * kInterval);
  EXPECT_FALSE(round.base.timing);
  EXPECT_FALSE(round.fit.timing);
  EXPECT_TRUE(round.base.by_timing.empty());
  EXPECT_NEAR(round.fit.values.back(), 2.0 * kInterval, 0.08 * kInterval);
}

TEST_F(TimingOfCommands, StandsBesideTheValuesUnlessItIsHeld) {
  const Round round = round_of(model_, 0.4 * kInterval);
  const Eigen::Index values = round.base.linear.front().values.cols();
  const std::vector<LinearSegment> free = beside_timing(round.base, false), held = beside_timing(round.base, true);
  ASSERT_EQ(free.front().values.cols(), values + 1);
  EXPECT_EQ(free.front().values.rightCols(1), round.base.by_timing.front());
  EXPECT_EQ(held.front().values.cols(), values);
}

TEST_F(TimingOfCommands, ChangesTheResidualAsItsDerivativeSays) {
  const Round round = round_of(model_, 0.4 * kInterval);
  BaseSolution later = round.base;
  constexpr double kMore = 0.1;
  *later.timing += kMore;
  linearise_timing(model_, round.bins, 1, later);
  for (std::size_t k = 0; k < later.linear.size(); ++k) {
    const Eigen::VectorXd change = later.linear[k].residual - round.base.linear[k].residual;
    EXPECT_LT((change - kMore * round.base.by_timing[k]).norm(), 0.05 * change.norm());
  }
}

/// An even distribution from one interval early to one late.
TEST_F(TimingOfCommands, IsAsUncertainAsBeforehandWhereTheDataTellNothing) {
  const Round round = round_of(model_, 0.4 * kInterval);
  std::vector<Eigen::MatrixXd> useless = round.factors;
  for (Eigen::MatrixXd& factor : useless) factor *= 1e6;
  const Refit fit = refit({model_.definition, *model_.model, {}}, without_values(round.base), round.bins, useless,
                          {round.base.values}, 1, {0.01, 1});
  EXPECT_NEAR(fit.covariance.bottomRightCorner(1, 1).value(), kTimingVariance, 1e-3);
}

TEST_F(TimingOfCommands, IsWhereAFitEndedForOneThatGoesOn) {
  const Round round = round_of(model_, 0.4 * kInterval);
  Refit ended = round.fit;
  ended.timing = 0.3;
  EXPECT_EQ(from(round.base, ended).timing, 0.3);
}

/// Without its delay the round's model, which does without timing, is compared with it at the best timing it can have.
TEST_F(TimingOfCommands, IsFittedToAnotherModelWhereTheRoundsDoesWithout) {
  const Round round = round_of(with_delay(1.4 * kInterval), 0.6 * kInterval);
  ASSERT_FALSE(round.base.timing);
  const Refit fit = refit_under(round, model_, 1);
  ASSERT_TRUE(fit.timing);
  EXPECT_NEAR(*fit.timing, 0.6, 0.08);
}

}  // namespace
}  // namespace lacuna
