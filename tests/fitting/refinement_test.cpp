#include "fitting/shooting/refinement.h"

#include "fitting/made_problem.h"
#include "fitting/shooting/refine_all.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna::refinement_test {
namespace {

using namespace lacuna::analytic;

constexpr double kSigma = 0.02;  // of a reading
constexpr double kLoss = 3.0;
constexpr double kFourErrors = 4.0 * 2.0 * kSigma / 10.0;  // of an intercept of 101 readings

double line(std::span<const double> p, double t) { return p[0] > 9.0 ? std::nan("") : p[0] + p[1] * t; }

Trial line_trial() { return formula_trial(line, {1.0, 2.0}, 5.0, 20.0, kSigma, 1); }

MadeProblem line_problem(const Trial& trial = line_trial(), int workers = 1) {
  return formula_problem(line, {free_value("a", 0.0, -10.0, 10.0), free_value("b", 0.0, -10.0, 10.0)}, {trial}, 0.0,
                         workers);
}

Candidate refined(MadeProblem& made, const std::vector<double>& from) {
  return refine(made.problem, made.at(from), {RobustLoss{kLoss}});
}

TEST(Refine, FindsTheValuesAndHowFarTheReadingsAreOff) {
  MadeProblem made = line_problem();
  const Candidate found = refined(made, {-5.0, 8.0});
  ASSERT_TRUE(found.valid);
  EXPECT_NEAR(found.values(0), 1.0, kFourErrors);
  EXPECT_NEAR(found.values(1), 2.0, kFourErrors);
  EXPECT_NEAR(found.residual, 1.0, 0.2) << "times the noise";
  EXPECT_EQ(found.samples, 101U);
  EXPECT_GE(found.scales[0], kSigma);
}

/// Every tenth reading is off by 5, which lifts a line of least squares by a tenth of that.
TEST(Refine, IsHardlyMisledByReadingsThatAreFarOff) {
  Trial trial = line_trial();
  for (Eigen::Index row = 3; row < 101; row += 10) trial.measured.samples(row, 0) += 5.0;
  MadeProblem made = line_problem(trial);
  const Candidate robust = refined(made, {0.9, 2.1});
  const Candidate squares = refine(made.problem, made.at({0.9, 2.1}), {RobustLoss{}});
  EXPECT_GT(squares.values(0) - 1.0, 0.4);
  EXPECT_LT(std::abs(robust.values(0) - 1.0), 0.1 * (squares.values(0) - 1.0));
  EXPECT_LT(robust.scales[0], 0.1 * squares.scales[0]) << "the scale is that of the other readings";
}

/// A parabola of which the line has nothing: its scale is the error of the model, not the noise.
TEST(Refine, WeighsReadingsByTheErrorOfTheModel) {
  Trial trial = line_trial();
  for (Eigen::Index row = 0; row < 101; ++row)
    trial.measured.samples(row, 0) += 0.3 * std::pow(trial.measured.times(row) - 2.5, 2);
  MadeProblem made = line_problem(trial);
  const Candidate found = refined(made, {0.0, 0.0});
  EXPECT_GT(found.scales[0], 10.0 * kSigma);
  EXPECT_GT(found.residual, 10.0);
}

TEST(Refine, IsNotValidWhereTheStartCannotBeSimulated) {
  MadeProblem made = line_problem();
  EXPECT_FALSE(refined(made, {9.5, 0.0}).valid);
}

TEST(Evaluate, HoldsTheValuesAndGivesTheObjectiveOfARefinementThere) {
  MadeProblem made = line_problem();
  const Candidate found = refined(made, {0.0, 0.0});
  const Candidate there = evaluate(made.problem, found.values, {RobustLoss{kLoss}});
  EXPECT_EQ(there.values, found.values);
  EXPECT_NEAR(there.objective, found.objective, 1e-6 * std::abs(found.objective));
  const Candidate beside = evaluate(made.problem, made.at({1.2, 2.0}), {RobustLoss{kLoss}});
  EXPECT_EQ(beside.values, made.at({1.2, 2.0}));
  EXPECT_GT(beside.objective, found.objective + 101.0);
}

/// The spring's initial states are fitted beside a damping that is held.
TEST(Evaluate, FitsInitialStates) {
  MadeProblem made = spring_problem({spring_trial(kNoise, 1)}, 1.0);
  const Candidate there = evaluate(made.problem, made.at({0.5}), {RobustLoss{kLoss}});
  ASSERT_TRUE(there.valid);
  EXPECT_NE(there.search.point.states, made.problem.start(made.at({0.5})).states);
  EXPECT_NEAR(there.residual, 1.0, 0.1);
}

Candidate with(double objective, bool valid = true) {
  Candidate candidate;
  candidate.valid = valid;
  candidate.objective = objective;
  candidate.values = Eigen::VectorXd::Constant(1, objective);
  return candidate;
}

std::vector<double> objectives(const std::vector<Candidate>& candidates) {
  std::vector<double> all;
  for (const Candidate& candidate : candidates) all.push_back(candidate.objective);
  return all;
}

/// Over 100 samples objectives that differ by less than 2 are of one error.
TEST(Rank, SortsByObjectiveAndCountsThoseThatReachTheBest) {
  std::vector<Candidate> candidates = {with(50.0, false), with(105.0), with(100.0), with(101.5)};
  EXPECT_EQ(rank(candidates, 100), 2);
  EXPECT_THAT(objectives(candidates), testing::ElementsAre(100.0, 101.5, 105.0, 50.0));
  EXPECT_FALSE(candidates.back().valid);
}

TEST(KeepBest, KeepsTheBestAndTheBestOfAnotherMinimum) {
  std::vector<Candidate> candidates = {with(100.0), with(101.5), with(105.0), with(110.0)};
  keep_best(candidates, 100);
  EXPECT_THAT(objectives(candidates), testing::ElementsAre(100.0, 105.0));
}

TEST(KeepBest, LeavesOutWhatIsHopelessOrNotValid) {
  std::vector<Candidate> candidates = {with(100.0), with(101.5), with(301.0), with(105.0, false)};
  keep_best(candidates, 100);
  EXPECT_THAT(objectives(candidates), testing::ElementsAre(100.0));
}

TEST(StartsOf, AreTheValuesOfTheCandidates) {
  const std::vector<Eigen::VectorXd> starts = starts_of({with(3.0), with(1.0)});
  ASSERT_EQ(starts.size(), 2U);
  EXPECT_EQ(starts[0](0), 3.0);
  EXPECT_EQ(starts[1](0), 1.0);
}

/// From three starts, on so many threads.
struct RefinedFromThree {
  explicit RefinedFromThree(int workers) : made(line_problem(line_trial(), workers)) {
    const std::vector<Eigen::VectorXd> starts = {made.at({-5.0, 8.0}), made.at({9.5, 0.0}), made.at({1.0, 2.0})};
    ProgressMeter meter(callback);
    meter.set_parts(3);
    found = refine_all(made.problem, starts, {RobustLoss{kLoss}}, meter, "search");
  }
  std::vector<std::string> parts;
  const ProgressCallback callback = [this](const Progress& now) {
    if (parts.empty() || parts.back() != now.what) parts.push_back(now.what);
  };
  MadeProblem made;
  std::vector<Candidate> found;
};

TEST(RefineAll, GivesEachStartWhatItWouldHaveAlone) {
  const RefinedFromThree three(1);
  ASSERT_EQ(three.found.size(), 3U);
  for (const std::size_t i : {0U, 2U}) {
    MadeProblem alone = line_problem();
    const std::vector<double> from = i == 0 ? std::vector{-5.0, 8.0} : std::vector{1.0, 2.0};
    EXPECT_EQ(three.found[i].values, refined(alone, from).values) << i;
  }
  EXPECT_FALSE(three.found[1].valid);
  EXPECT_THAT(three.parts, testing::ElementsAre("search, 1 of 3", "search, 2 of 3", "search, 3 of 3"));
}

TEST(RefineAll, GivesTheSameDigitsWithAnyNumberOfThreadsAndCountsAllSimulations) {
  const RefinedFromThree one(1), many(6);
  for (const std::size_t i : {0U, 2U}) EXPECT_EQ(one.found[i].values, many.found[i].values) << i;
  EXPECT_EQ(one.made.problem.simulations(), many.made.problem.simulations());
  EXPECT_EQ(many.made.problem.invalid_simulations(), 1U);
  EXPECT_GT(many.made.problem.simulations(), 10U);
}

TEST(RefineAll, OfNoStartsIsNothing) {
  MadeProblem made = line_problem();
  const ProgressCallback nobody;
  ProgressMeter meter(nobody);
  EXPECT_TRUE(refine_all(made.problem, {}, {RobustLoss{kLoss}}, meter, "search").empty());
}

}  // namespace
}  // namespace lacuna::refinement_test
