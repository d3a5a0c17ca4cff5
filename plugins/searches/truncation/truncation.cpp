#include <lacuna/count_parameter.h>
#include <lacuna/error.h>
#include <lacuna/generational_search.h>
#include <lacuna/plugin.h>
#include <lacuna/search_strategy.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace lacuna {

/// The seed's search (Bongard and Lipson, experiment 1): each generation keeps the best and replaces the others by
/// their children. Survivors keep their scores. An evaluation may be abandoned as soon as it is worse than the worst
/// survivor.
class Truncation : public SearchStrategy {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  /// Throws `Error` where no individual would be replaced.
  std::unique_ptr<Search> begin(const SearchTask& task, std::span<const double> parameters) const override;
};

namespace {

enum Parameter : std::size_t { kPopulation, kKeep, kGenerations };

class TruncationSearch : public GenerationalSearch {
 public:
  TruncationSearch(const SearchTask& task, std::size_t population, std::size_t keep, std::size_t generations)
      : GenerationalSearch(task, generations), population_(population), keep_(keep) {}

  /// A child only replaces the worst survivor, which stays where both are equal.
  std::optional<double> abandon_above() const override {
    if (kept().empty() || std::isinf(kept().back().score)) return std::nullopt;
    return kept().back().score;
  }

 private:
  std::vector<Individual> do_ask() override {
    std::vector<Individual> newcomers;
    if (generation() == 0) {
      for (std::size_t i = 0; i < population_; ++i) newcomers.push_back({0, first_genome(i), {}});
      return newcomers;
    }
    std::vector<Genome> survivors;
    for (const ScoredIndividual& one : kept()) survivors.push_back(one.individual.genome);
    for (std::size_t i = 0; i < population_ - keep_; ++i) newcomers.push_back(child(survivors, i));
    return newcomers;
  }

  Individual child(const std::vector<Genome>& survivors, std::size_t index) const {
    RandomStream random = stream(index);
    std::vector<std::size_t> used;
    Individual individual{0, task().breeder.child(survivors, random, used), {}};
    for (const std::size_t parent : used) individual.parents.push_back(kept()[parent].individual.number);
    return individual;
  }

  /// Survivors are sorted best first.
  void do_tell(std::vector<ScoredIndividual> told) override {
    kept().insert(kept().end(), std::make_move_iterator(told.begin()), std::make_move_iterator(told.end()));
    std::sort(kept().begin(), kept().end(), better);
    kept().resize(keep_);
  }

  std::size_t population_;
  std::size_t keep_;
};

}  // namespace

std::string Truncation::summary() const {
  return "Keeps the best of each generation and replaces the others by their children";
}

ParameterDeclarations Truncation::parameters() const {
  return {{"population", "1", 100.0, 2.0, 1e6, Scale::linear, "Individuals per generation"},
          {"keep", "1", 50.0, 1.0, 1e6, Scale::linear, "How many of them survive"},
          {"generations", "1", 30.0, 1.0, 1e6, Scale::linear, "Generations, including the random one"}};
}

std::unique_ptr<Search> Truncation::begin(const SearchTask& task, std::span<const double> parameters) const {
  const ParameterDeclarations declared = this->parameters();
  const std::size_t population = count_parameter(declared[kPopulation], parameters[kPopulation]);
  const std::size_t keep = count_parameter(declared[kKeep], parameters[kKeep]);
  if (keep >= population)
    throw Error("keep = " + std::to_string(keep) + " of a population of " + std::to_string(population) +
                " leaves none to replace; keep fewer, such as half");
  return std::make_unique<TruncationSearch>(task, population, keep,
                                            count_parameter(declared[kGenerations], parameters[kGenerations]));
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::SearchStrategy, lacuna::Truncation>("truncation"))
