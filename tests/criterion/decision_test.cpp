#include "criterion/decision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lacuna::decision_test {
namespace {

constexpr Eigen::Index kLengths = 3, kBlocks = 40;

/// A set whose cost lies `gain` below that of the model as it is, evenly over lengths, with a scatter of its own.
CandidateSet set_of(std::set<std::string> members, double gain, int told, std::uint64_t seed = 0) {
  std::mt19937_64 bits(seed);
  std::normal_distribution<double> normal(0.0, 0.02 / kBlocks);
  CandidateSet set{std::move(members), told, told, {Eigen::MatrixXd(kLengths, kBlocks), 0.0}, {}, {}};
  for (Eigen::Index i = 0; i < kLengths; ++i)
    for (Eigen::Index j = 0; j < kBlocks; ++j)
      set.cost.by_length(i, j) = (2.0 - gain) / (kLengths * kBlocks) + (seed == 0 ? 0.0 : normal(bits));
  set.cost.cost = set.cost.by_length.sum();
  set.mean_square = Eigen::VectorXd::Constant(1, 3.0 * std::exp(2.0 * (2.0 - gain)));  // 3: above the noise
  return set;
}

TEST(Decision, NamesTheEffectThatGains) {
  const Decision decision = decide({set_of({}, 0.0, 0), set_of({"a"}, 1.0, 1, 1), set_of({"b"}, 0.1, 1, 2)}, {}, 1);
  EXPECT_EQ(decision.answer, 1U);
  EXPECT_TRUE(decision.alike.empty());
  EXPECT_LT(decision.p, 0.01);
}

TEST(Decision, NamesNothingWhereNothingGains) {
  const Decision decision = decide({set_of({}, 0.0, 0), set_of({"a"}, -0.01, 1, 1), set_of({"b"}, 0.0, 1, 2)}, {}, 1);
  EXPECT_EQ(decision.answer, 0U);
}

TEST(Decision, TakesTheFewerValuesOfSetsThatAreAsGood) {
  const Decision decision = decide({set_of({}, 0.0, 0), set_of({"rich"}, 1.01, 3, 1), set_of({"simple"}, 1.0, 1, 2),
                                    set_of({"as simple"}, 0.99, 1, 3)},
                                   {}, 1);
  EXPECT_EQ(decision.answer, 2U);
  EXPECT_EQ(decision.alike, std::vector<std::size_t>{3U}) << "a richer law that does the same is no other answer";
}

TEST(Decision, AddsASecondEffectThatEarnsItsShare) {
  const std::vector<CandidateSet> sets{set_of({}, 0.0, 0), set_of({"a"}, 1.0, 1, 1), set_of({"b"}, 0.4, 1, 2),
                                       set_of({"a", "b"}, 1.5, 2, 3), set_of({"a", "c"}, 1.02, 2, 4)};
  EXPECT_EQ(decide(sets, {}, 1).answer, 3U);
  const std::vector<CandidateSet> little{sets[0], sets[1], sets[2], set_of({"a", "b"}, 1.03, 2, 3)};
  EXPECT_EQ(decide(little, {}, 1).answer, 1U);
}

/// The interval of its size holds the value at which it does nothing.
TEST(Decision, LeavesOutAnEffectThatMayDoNothing) {
  std::vector<CandidateSet> sets{set_of({}, 0.0, 0), set_of({"a"}, 1.0, 1, 1), set_of({"c"}, 1.2, 1, 4),
                                 set_of({"a", "b"}, 1.5, 2, 3)};
  EXPECT_EQ(decide(sets, {}, 1).answer, 3U);
  sets[3].idle = {"b"};
  EXPECT_EQ(decide(sets, {}, 1).answer, 1U) << "the rest of what gains most, not another effect";
  EXPECT_EQ(decide(sets, {}, 1).best, 3U);
  EXPECT_EQ(decide(sets, {}, 1).idle, std::set<std::string>{"b"});
}

/// It explains errors that no other set does; alone its interval is no reason for another answer.
TEST(Decision, NamesAnEffectByItselfThoughItsValueIsNotTold) {
  std::vector<CandidateSet> sets{set_of({}, 0.0, 0), set_of({"a"}, 1.0, 1, 1), set_of({"c"}, 0.8, 1, 4)};
  sets[1].idle = {"a"};
  EXPECT_EQ(decide(sets, {}, 1).answer, 1U);
  EXPECT_TRUE(decide(sets, {}, 1).idle.empty());
}

/// The root of what is left falls from 1 to 0.2 by the first effect, by 0.12 more by the second.
TEST(Decision, NamesNothingBesideAnAnswerThatTakesLessThanAFifthOfTheError) {
  const std::vector<CandidateSet> sets{set_of({}, 0.0, 0), set_of({"a"}, 1.6, 1, 1), set_of({"a", "b"}, 1.8, 2, 2)};
  EXPECT_LT(share_of_error(sets[2], sets[1], sets[0]), 0.2);
  EXPECT_EQ(decide(sets, {}, 1).answer, 1U);
}

/// Beside an offset far above all else what halves the rest again and again is no minor effect.
/// The same where errors are at the noise with both, and not with one.
TEST(Decision, NamesWhatCompletesAnAnswer) {
  std::vector<CandidateSet> sets{set_of({}, 0.0, 0), set_of({"a"}, 1.6, 1, 1), set_of({"a", "b"}, 1.8, 2, 2)};
  sets[2].mean_square.setConstant(1.05);
  EXPECT_LT(share_of_error(sets[2], sets[1], sets[0]), 0.4);
  EXPECT_EQ(decide(sets, {}, 1).answer, 2U);
  EXPECT_EQ(decide(sets, {}, 1).best, 2U);
}

TEST(Decision, NamesASecondEffectThatMakesTwoFifthsOfTheGain) {
  std::vector<CandidateSet> sets{set_of({}, 0.0, 0), set_of({"a"}, 1.1, 1, 1), set_of({"a", "b"}, 2.0, 2, 2)};
  sets[0].mean_square(0) = 1e6;
  EXPECT_LT(share_of_error(sets[2], sets[1], sets[0]), 0.01);
  EXPECT_EQ(decide(sets, {}, 1).answer, 2U);
}

TEST(ShareOfError, IsThatOfTheCellWhereItIsLargest) {
  CandidateSet model = set_of({}, 0.0, 0), part = model, set = model;
  model.mean_square = Eigen::Vector3d(100.0, 0.0, 4.0);
  part.mean_square = Eigen::Vector3d(26.0, 0.0, 3.0);
  set.mean_square = Eigen::Vector3d(1.0, 0.0, 3.5);
  EXPECT_DOUBLE_EQ(share_of_error(set, part, model), 0.5);
}

/// Of many laws that were looked at one gains by chance as much as the best that was fitted.
TEST(Decision, CountsWhatWasLookedAtBesideASet) {
  std::mt19937_64 bits(7);
  std::normal_distribution<double> normal(0.0, 1.0);
  CandidateSet weak = set_of({"a"}, 0.2, 1);
  for (double& cost : weak.cost.by_length.reshaped()) cost += 0.01 * normal(bits);
  const std::vector<CandidateSet> sets{set_of({}, 0.0, 0), weak};
  LookedBeside looked;
  for (int law = 0; law < 400; ++law) {
    looked.gains.emplace_back(kBlocks);
    for (double& gain : looked.gains.back()) gain = normal(bits);
  }
  EXPECT_GT(decide(sets, {looked}, 1).p, 2.0 * decide(sets, {}, 1).p);
  looked.members = {"another"};
  EXPECT_DOUBLE_EQ(decide(sets, {looked}, 1).p, decide(sets, {}, 1).p);
}

TEST(Decision, NamesNothingThatLowersTheErrorByLessThanATwentieth) {
  EXPECT_EQ(decide({set_of({}, 0.0, 0), set_of({"a"}, 0.04, 1, 1)}, {}, 1).answer, 0U);
  EXPECT_EQ(decide({set_of({}, 0.0, 0), set_of({"a"}, 0.07, 1, 1)}, {}, 1).answer, 1U);
}

TEST(LargestGain, IsThatOfOneLength) {
  CandidateSet one = set_of({"a"}, 0.0, 1);
  one.cost.by_length.row(1).array() -= 0.2 / (kLengths * kBlocks);
  EXPECT_NEAR(largest_gain(one, set_of({}, 0.0, 0)), 0.2, 1e-12);
}

TEST(Decision, BelievesNothingThatGainsAtOneLengthAlone) {
  CandidateSet one = set_of({"a"}, 0.0, 1, 1);
  one.cost.by_length.row(2).array() -= 1.0 / kBlocks;
  EXPECT_GT(gain_of(one, set_of({}, 0.0, 0)).nats, 0.9);
  EXPECT_EQ(decide({set_of({}, 0.0, 0), one}, {}, 1).answer, 0U);
}

/// Friction by direction is a dry friction and a constant torque: one effect, not two.
TEST(Decision, TakesTheSetOfFewestEffectsOfThoseOfAsManyValues) {
  const std::vector<CandidateSet> sets = {set_of({}, 0.0, 0), set_of({"a", "b"}, 1.0, 2, 1),
                                          set_of({"both"}, 0.999, 2, 1)};
  EXPECT_EQ(decide(sets, {}, 1).answer, 2U);
}

/// Friction in two joints is simpler than friction in one and a drag on a body, which does the same.
TEST(Decision, TakesTheSetOfFewestEffectsOfThoseOfAsManyMembers) {
  const std::vector<CandidateSet> sets = {set_of({}, 0.0, 0),
                                          set_of({"drag @ body.a", "friction @ joint.b"}, 1.0, 2, 1),
                                          set_of({"friction @ joint.a", "friction @ joint.b"}, 0.999, 2, 1)};
  EXPECT_EQ(decide(sets, {}, 1).answer, 2U);
}

/// Of sets that tell as many values the one that has fewer in all: a law with values that nothing tells is no simpler.
TEST(Decision, TakesTheSetOfFewestValuesOfThoseThatTellAsMany) {
  std::vector<CandidateSet> sets = {set_of({}, 0.0, 0), set_of({"rich"}, 1.0, 1, 1), set_of({"plain"}, 0.999, 1, 1)};
  sets[1].values = 6;
  EXPECT_EQ(decide(sets, {}, 1).answer, 2U);
  sets[2].values = 7;
  EXPECT_EQ(decide(sets, {}, 1).answer, 1U);
}

}  // namespace
}  // namespace lacuna::decision_test
