#include "plugins/search_problems.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <utility>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kSolved = 1e-8;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

class SearchTest : public testing::Test {
 protected:
  std::unique_ptr<Search> begin(const std::string& name, const std::vector<double>& parameters,
                                std::uint64_t key = 1) const {
    return built_catalog().get<SearchStrategy>(name).begin({layout_, breeder_, {key}, seeds_}, parameters);
  }
  /// Of five searches.
  double median_evaluations(const std::string& name, const std::vector<double>& parameters,
                            const Objective& objective) const {
    std::vector<double> evaluations;
    for (std::uint64_t key = 1; key <= 5; ++key)
      evaluations.push_back(evaluations_to(kSolved, *begin(name, parameters, key), objective));
    return median(evaluations);
  }

  GenomeLayout layout_ = problem_layout();
  RandomBreeder breeder_{layout_};
  std::vector<Genome> seeds_;
};

/// Its children halve the distance of their parent to the middle.
class HalvingBreeder : public RandomBreeder {
 public:
  using RandomBreeder::RandomBreeder;
  Genome child(std::span<const Genome> parents, RandomStream& random, std::vector<std::size_t>& used) const override {
    used = {random.index(parents.size())};
    Genome child = parents[used[0]];
    for (double& gene : child) gene = 0.5 * (gene + 0.5);
    return child;
  }
};

class TruncationTest : public SearchTest {
 protected:
  std::unique_ptr<Search> begin(const std::vector<double>& parameters) const {
    return built_catalog().get<SearchStrategy>("truncation").begin({layout_, halving_, {1}, seeds_}, parameters);
  }
  HalvingBreeder halving_{layout_};
};

TEST_F(TruncationTest, ThePapersRunTakes1550Evaluations) {
  std::size_t evaluations = 0;
  const auto search = begin({100, 50, 30});
  while (!search->finished()) {
    evaluations += search->ask().size();
    search->tell(std::vector<double>(search->ask().size(), 1.0));
  }
  EXPECT_EQ(evaluations, 100U + 29U * 50U);
}

TEST_F(TruncationTest, KeepsTheBestAndTheirScores) {
  const auto search = begin({6, 3, 3});
  search->ask();
  search->tell(std::array{5.0, 1.0, 4.0, 2.0, 3.0, 6.0});
  const auto numbers = [&] {
    std::vector<std::uint64_t> all;
    for (const ScoredIndividual& one : search->best()) all.push_back(one.individual.number);
    return all;
  };
  EXPECT_THAT(numbers(), testing::ElementsAre(1, 3, 4));
  EXPECT_EQ(search->ask().size(), 3U);
  EXPECT_EQ(search->abandon_above(), 3.0);
  search->tell(std::array{3.0, 1.5, 9.0});
  EXPECT_THAT(numbers(), testing::ElementsAre(1, 7, 3)) << "of equal scores the older one is the better";
  EXPECT_EQ(search->abandon_above(), 2.0);
}

TEST_F(TruncationTest, ChildrenAreTheSurvivorsAndNameThem) {
  const auto search = begin({6, 3, 2});
  const std::vector<Individual> first = search->ask();
  EXPECT_EQ(search->abandon_above(), std::nullopt);
  search->tell(std::array{5.0, 1.0, 4.0, 2.0, 3.0, 6.0});
  for (const Individual& child : search->ask()) {
    ASSERT_EQ(child.parents.size(), 1U);
    EXPECT_THAT(child.parents[0], testing::AnyOf(1, 3, 4));
    EXPECT_EQ(child.genome[0], 0.5 * (first[child.parents[0]].genome[0] + 0.5));
  }
}

TEST_F(TruncationTest, BeginsWithAllSeeds) {
  seeds_ = {Genome(kProblemGenes, 0.25), Genome(kProblemGenes, 0.75)};
  const std::vector<Individual> first = begin({6, 3, 2})->ask();
  EXPECT_EQ(first[0].genome, seeds_[0]);
  EXPECT_EQ(first[1].genome, seeds_[1]);
  EXPECT_NE(first[2].genome, seeds_[0]);
}

TEST_F(TruncationTest, RefusesSettingsThatLeaveNothingToDo) {
  EXPECT_THAT([&] { begin({50, 50, 30}); }, ThrowsMessage<Error>(HasSubstr("keep = 50 of a population of 50")));
  EXPECT_THAT([&] { begin({50.5, 20, 30}); }, ThrowsMessage<Error>(HasSubstr("population = 50.5")));
}

class DifferentialEvolutionTest : public SearchTest {
 protected:
  double solve(const Objective& objective) const {
    return median_evaluations("differential_evolution", {40, 2000, 0.6, 0.9}, objective);
  }
};

TEST_F(DifferentialEvolutionTest, SolvesTheSphere) { EXPECT_LT(solve(sphere), 15000); }
TEST_F(DifferentialEvolutionTest, SolvesTheEllipsoid) { EXPECT_LT(solve(ellipsoid), 20000); }
TEST_F(DifferentialEvolutionTest, SolvesRosenbrocksValley) { EXPECT_LT(solve(rosenbrock), 50000); }

/// Without crossover but for one gene, a challenger is its target with one gene of the mutant.
TEST_F(DifferentialEvolutionTest, ChallengersAreMutantsOfThreeOthers) {
  constexpr double kWeight = 0.1, kLastDigits = 1e-12;
  const auto search = begin("differential_evolution", {4, 2, kWeight, 0.0});
  const std::vector<Individual> first = search->ask();
  search->tell(std::vector<double>(4, 1.0));
  const std::vector<Individual> challengers = search->ask();
  for (std::size_t target = 0; target < 4; ++target) {
    const Individual& challenger = challengers[target];
    ASSERT_EQ(challenger.parents.size(), 2U);
    EXPECT_EQ(challenger.parents[0], target);
    const std::size_t base = challenger.parents[1];
    ASSERT_NE(base, target);
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < 4; ++i)
      if (i != target && i != base) others.push_back(i);
    int changed = 0;
    for (std::size_t i = 0; i < kProblemGenes; ++i) {
      if (challenger.genome[i] == first[target].genome[i]) continue;
      ++changed;
      const double step = kWeight * (first[others[0]].genome[i] - first[others[1]].genome[i]);
      const double moved = challenger.genome[i] - first[base].genome[i];
      EXPECT_NEAR(std::abs(moved), std::abs(step), kLastDigits);
    }
    EXPECT_EQ(changed, 1);
  }
}

TEST_F(DifferentialEvolutionTest, AChallengerWinsWhereItIsAsGood) {
  const auto search = begin("differential_evolution", {4, 2, 0.5, 0.9});
  search->ask();
  search->tell(std::array{1.0, 2.0, 3.0, 4.0});
  search->ask();
  EXPECT_EQ(search->abandon_above(), 4.0);
  search->tell(std::array{1.5, 2.0, 2.5, 5.0});
  std::vector<std::uint64_t> numbers;
  for (const ScoredIndividual& one : search->best()) numbers.push_back(one.individual.number);
  EXPECT_THAT(numbers, testing::ElementsAre(0, 5, 6, 3));
}

TEST_F(DifferentialEvolutionTest, NeedsFour) {
  EXPECT_THAT(
      [&] {
        begin("differential_evolution", {3, 2, 0.5, 0.9});
      },
      ThrowsMessage<Error>(HasSubstr("at least 4")));
}

class CmaEsTest : public SearchTest {
 protected:
  double solve(const Objective& objective) const { return median_evaluations("cma_es", {0, 2000, 0.3}, objective); }
};

TEST_F(CmaEsTest, SolvesTheSphere) { EXPECT_LT(solve(sphere), 2500); }
TEST_F(CmaEsTest, SolvesTheTurnedEllipsoid) { EXPECT_LT(solve(turned_ellipsoid), 8000); }
TEST_F(CmaEsTest, SolvesRosenbrocksValley) { EXPECT_LT(solve(rosenbrock), 9000); }

TEST_F(CmaEsTest, PopulationIsTheTutorialsDefault) {
  EXPECT_EQ(begin("cma_es", {0, 2, 0.3})->ask().size(), 10U);  // 4 + 3 ln 10
  EXPECT_EQ(begin("cma_es", {24, 2, 0.3})->ask().size(), 24U);
}

/// A sphere whose centre lies outside: the best point of the box is the nearest one.
TEST_F(CmaEsTest, FindsAnOptimumOnTheBounds) {
  const auto centre = [](std::size_t i) { return i % 2 == 0 ? 0.4 : (i % 4 == 1 ? -0.5 : 1.7); };
  double least = 0.0;
  for (std::size_t i = 0; i < kProblemGenes; ++i) least += std::pow(centre(i) - std::clamp(centre(i), 0.0, 1.0), 2);
  const Objective problem = [&](std::span<const double> x) {
    double sum = -least;
    for (std::size_t i = 0; i < x.size(); ++i) sum += std::pow(x[i] - centre(i), 2);
    return sum;
  };
  EXPECT_LT(solve(problem), 4000);
}

TEST_F(CmaEsTest, BeginsAtTheFirstSeedAndSamplesAroundIt) {
  seeds_ = {Genome(kProblemGenes, 0.25)};
  constexpr double kSigma = 0.01, kFarthest = 6.0 * kSigma;
  const std::vector<Individual> first = begin("cma_es", {0, 2, kSigma})->ask();
  EXPECT_EQ(first[0].genome, seeds_[0]);
  for (const Individual& one : first)
    for (const double gene : one.genome) EXPECT_NEAR(gene, 0.25, kFarthest);
}

TEST_F(CmaEsTest, AGenomeOfOneGeneIsNoTrouble) {
  layout_.genes.resize(1);
  EXPECT_LT(solve([](std::span<const double> x) { return std::pow(x[0] - 0.8, 2); }), 500);
}

TEST_F(CmaEsTest, NeedsTwo) {
  EXPECT_THAT(
      [&] {
        begin("cma_es", {1, 2, 0.3});
      },
      ThrowsMessage<Error>(HasSubstr("needs a population of at least 2")));
}

class PairedTournamentTest : public SearchTest {
 protected:
  std::unique_ptr<Search> begin(const std::vector<double>& parameters) const {
    return built_catalog().get<SearchStrategy>("paired_tournament").begin({layout_, halving_, {1}, seeds_}, parameters);
  }
  static std::vector<double> spheres(const std::vector<Individual>& individuals) {
    std::vector<double> scores;
    for (const Individual& one : individuals) scores.push_back(sphere(one.genome));
    return scores;
  }
  HalvingBreeder halving_{layout_};
};

/// Two individuals: whichever is drawn first, the better one overwrites the other, one pair after the other.
TEST_F(PairedTournamentTest, TheFitterOverwritesTheOtherAndIsVaried) {
  const auto search = begin({2.0, 3.0, 2.0});
  const std::vector<Individual> first = search->ask();
  ASSERT_EQ(first.size(), 2U);
  search->tell(std::vector{5.0, 3.0});
  Genome halved = first[1].genome;
  for (double& gene : halved) gene = 0.5 * (gene + 0.5);
  std::vector<Individual> asked = search->ask();
  ASSERT_EQ(asked.size(), 1U) << "the next pair waits for this child's score";
  EXPECT_EQ(asked[0].genome, halved);
  EXPECT_EQ(asked[0].parents, std::vector<std::uint64_t>{1});
  search->tell(std::vector{1.0});
  EXPECT_EQ(search->generation(), 1) << "two pairs of the generation are left";
  asked = search->ask();
  EXPECT_EQ(asked[0].parents, std::vector<std::uint64_t>{2}) << "the child has beaten its parent";
  search->tell(std::vector{4.0});
  EXPECT_EQ(search->ask()[0].parents, std::vector<std::uint64_t>{2}) << "and now its own child";
  search->tell(std::vector{9.0});
  EXPECT_TRUE(search->finished());
  const std::vector<ScoredIndividual> best = search->best();
  ASSERT_EQ(best.size(), 2U);
  EXPECT_EQ(best[0].score, 1.0);
  EXPECT_EQ(best[1].score, 9.0);
}

/// Gives one gene a new value, so that a child says which random numbers it had.
class ResettingBreeder : public RandomBreeder {
 public:
  using RandomBreeder::RandomBreeder;
  Genome child(std::span<const Genome> parents, RandomStream& random, std::vector<std::size_t>& used) const override {
    used = {random.index(parents.size())};
    Genome child = parents[used[0]];
    child[random.index(child.size())] = random.uniform();
    return child;
  }
};

/// Pairs one after the other, each child scored before the next pair is drawn: the children, in their order.
std::vector<Individual> one_by_one(std::vector<ScoredIndividual> population, const Breeder& breeder, std::size_t pairs,
                                   std::uint64_t generations) {
  std::vector<Individual> children;
  std::uint64_t number = population.size();
  for (std::uint64_t generation = 1; generation < generations; ++generation)
    for (std::uint64_t pair = 0; pair < pairs; ++pair) {
      RandomStream random(std::array<std::uint64_t, 3>{1, generation, pair});
      const std::size_t one = random.index(population.size());
      std::size_t other = random.index(population.size() - 1);
      other += other >= one ? 1 : 0;
      const auto rank = [&](std::size_t i) { return std::pair(population[i].score, population[i].individual.number); };
      const std::size_t winner = rank(one) < rank(other) ? one : other, loser = one + other - winner;
      const Individual& parent = population[winner].individual;
      std::vector<std::size_t> used;
      children.push_back({number++, breeder.child({&parent.genome, 1}, random, used), {parent.number}});
      population[loser] = {children.back(), sphere(children.back().genome)};
    }
  return children;
}

/// The same pairs as if each child were scored before the next pair is drawn.
TEST_F(PairedTournamentTest, PairsThatDoNotWaitAreAskedTogether) {
  const ResettingBreeder breeder(layout_);
  const auto search = built_catalog()
                          .get<SearchStrategy>("paired_tournament")
                          .begin({layout_, breeder, {1}, seeds_}, std::vector{40.0, 30.0, 3.0});
  std::vector<ScoredIndividual> first;
  for (const Individual& one : search->ask()) first.push_back({one, sphere(one.genome)});
  search->tell(spheres(search->ask()));
  std::vector<Individual> children;
  std::size_t parts = 0;
  for (; !search->finished(); ++parts) {
    const std::vector<Individual> asked = search->ask();
    children.insert(children.end(), asked.begin(), asked.end());
    search->tell(spheres(asked));
  }
  EXPECT_GT(parts, 2U);
  EXPECT_LT(parts, 60U);
  const std::vector<Individual> expected = one_by_one(first, breeder, 30, 3);
  ASSERT_EQ(children.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(children[i].number, expected[i].number);
    EXPECT_EQ(children[i].genome, expected[i].genome) << "child " << i;
    EXPECT_EQ(children[i].parents, expected[i].parents) << "child " << i;
  }
}

TEST_F(PairedTournamentTest, RefusesAnothersState) {
  const auto search = begin({4.0, 3.0, 2.0});
  search->tell(spheres(search->ask()));
  const std::vector<double> state = search->save();
  begin({4.0, 3.0, 2.0})->load(state);
  EXPECT_THAT([&] { begin({5.0, 3.0, 2.0})->load(state); }, ThrowsMessage<Error>(HasSubstr("5 individuals")));
  EXPECT_THAT([&] { begin({4.0, 2.0, 2.0})->load(state); }, ThrowsMessage<Error>(HasSubstr("2 pairs")));
}

}  // namespace
}  // namespace lacuna
