#include "plugins/search_problems.h"

#include <gtest/gtest.h>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/de.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>

#include <algorithm>
#include <memory>
#include <utility>

/// Our searches need as many evaluations as another implementation of the same literature.
namespace lacuna {
namespace {

constexpr unsigned kSearches = 15;
constexpr double kSolved = 1e-8;
constexpr double kTolerance = 0.25;  // of a median's evaluations

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Counts until the problem is solved.
struct Tally {
  double evaluations = 0.0;
  bool solved = false;
};

struct CountedProblem {
  Objective objective;
  std::shared_ptr<Tally> tally;  // shared: pagmo copies its problems

  pagmo::vector_double fitness(const pagmo::vector_double& x) const {
    const double score = objective(x);
    if (!tally->solved) ++tally->evaluations;
    tally->solved = tally->solved || score <= kSolved;
    return {score};
  }
  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    return {pagmo::vector_double(kProblemGenes, 0.0), pagmo::vector_double(kProblemGenes, 1.0)};
  }
};

std::vector<Genome> random_genomes(std::size_t count, unsigned seed) {
  RandomStream random(std::vector<std::uint64_t>{seed});
  std::vector<Genome> genomes;
  for (std::size_t i = 0; i < count; ++i) genomes.push_back(uniform_genome(problem_layout(), random));
  return genomes;
}

/// Those of the first population are counted, too.
template <class Algorithm>
double pagmos_evaluations(const Algorithm& search, const std::vector<Genome>& first, const Objective& objective) {
  const auto tally = std::make_shared<Tally>();
  pagmo::population population{pagmo::problem(CountedProblem{objective, tally})};
  for (const Genome& genome : first) population.push_back(genome);
  search.evolve(population);
  return tally->solved ? tally->evaluations : std::numeric_limits<double>::infinity();
}

double our_evaluations(const std::string& name, const std::vector<double>& parameters, const std::vector<Genome>& first,
                       unsigned seed, const Objective& objective) {
  const GenomeLayout layout = problem_layout();
  const RandomBreeder breeder(layout);
  const auto search = built_catalog().get<SearchStrategy>(name).begin({layout, breeder, {seed}, first}, parameters);
  return evaluations_to(kSolved, *search, objective);
}

void expect_the_same(const std::vector<double>& ours, const std::vector<double>& pagmos) {
  ASSERT_TRUE(std::isfinite(median(pagmos)));
  EXPECT_NEAR(median(ours) / median(pagmos), 1.0, kTolerance);
  ::testing::Test::RecordProperty("ours", std::to_string(median(ours)));
  ::testing::Test::RecordProperty("pagmos", std::to_string(median(pagmos)));
}

void compare_cma_es(const Objective& objective) {
  constexpr unsigned kGenerations = 1200;
  constexpr std::size_t kPopulation = 10;  // 4 + 3 ln 10
  constexpr double kSigma = 0.3;
  std::vector<double> ours, pagmos;
  for (unsigned seed = 1; seed <= kSearches; ++seed) {
    const Genome start = random_genomes(1, seed).front();
    ours.push_back(our_evaluations("cma_es", {kPopulation, kGenerations, kSigma}, {start}, seed, objective));
    const pagmo::cmaes search(kGenerations, -1, -1, -1, -1, kSigma, 0.0, 0.0, false, false, seed);
    pagmos.push_back(pagmos_evaluations(search, std::vector(kPopulation, start), objective));
  }
  expect_the_same(ours, pagmos);
}

void compare_differential_evolution(const Objective& objective) {
  constexpr unsigned kGenerations = 1500;
  constexpr std::size_t kPopulation = 40;
  constexpr double kWeight = 0.6, kCrossover = 0.9;
  constexpr unsigned kRand1Bin = 7;
  std::vector<double> ours, pagmos;
  for (unsigned seed = 1; seed <= kSearches; ++seed) {
    const std::vector<Genome> first = random_genomes(kPopulation, seed);
    ours.push_back(our_evaluations("differential_evolution", {kPopulation, kGenerations, kWeight, kCrossover}, first,
                                   seed, objective));
    const pagmo::de search(kGenerations, kWeight, kCrossover, kRand1Bin, 0.0, 0.0, seed);
    pagmos.push_back(pagmos_evaluations(search, first, objective));
  }
  expect_the_same(ours, pagmos);
}

TEST(CmaEsAndPagmos, NeedTheSameForTheSphere) { compare_cma_es(sphere); }
TEST(CmaEsAndPagmos, NeedTheSameForTheTurnedEllipsoid) { compare_cma_es(turned_ellipsoid); }
TEST(CmaEsAndPagmos, NeedTheSameForRosenbrocksValley) { compare_cma_es(rosenbrock); }

TEST(DifferentialEvolutionAndPagmos, NeedTheSameForTheSphere) { compare_differential_evolution(sphere); }
TEST(DifferentialEvolutionAndPagmos, NeedTheSameForTheEllipsoid) { compare_differential_evolution(ellipsoid); }
TEST(DifferentialEvolutionAndPagmos, NeedTheSameForRosenbrocksValley) { compare_differential_evolution(rosenbrock); }

}  // namespace
}  // namespace lacuna
