#include <lacuna/count_parameter.h>
#include <lacuna/error.h>
#include <lacuna/generational_search.h>
#include <lacuna/plugin.h>
#include <lacuna/search_strategy.h>

#include <algorithm>
#include <string>
#include <utility>

namespace lacuna {

/// The search of the seed's experiment 2: pairs drawn one after the other; a mutated copy of the fitter individual
/// replaces the other. A generation is a fixed number of pairs. Pairs whose individuals have a score are asked
/// together.
class PairedTournament : public SearchStrategy {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  std::unique_ptr<Search> begin(const SearchTask& task, std::span<const double> parameters) const override;
};

namespace {

enum Parameter : std::size_t { kPopulation, kPairs, kGenerations };

class PairedTournamentSearch : public GenerationalSearch {
 public:
  PairedTournamentSearch(const SearchTask& task, std::size_t population, std::size_t pairs, std::size_t generations)
      : GenerationalSearch(task, generations), population_(population), pairs_(pairs) {}

 private:
  /// The next pairs, in their order, up to the first that depends on the pending score of a child. `kept()` is the
  /// population, place by place.
  std::vector<Individual> do_ask() override {
    std::vector<Individual> asked;
    overwritten_.clear();
    if (generation() == 0) {
      for (std::size_t i = 0; i < population_; ++i) asked.push_back({0, first_genome(i), {}});
      return asked;
    }
    for (std::size_t pair = next_pair(); pair < pairs_; ++pair) {
      RandomStream random = stream(pair);
      const std::size_t one = random.index(population_);
      const std::size_t draw = random.index(population_ - 1);
      const std::size_t other = draw + (draw >= one ? 1 : 0);
      if (waits(one) || waits(other)) break;
      const auto [winner, loser] = better(kept()[other], kept()[one]) ? std::pair(other, one) : std::pair(one, other);
      asked.push_back(child_of(winner, random));
      overwritten_.push_back(loser);
    }
    return asked;
  }

  std::size_t next_pair() const { return done_ == pairs_ ? 0 : done_; }

  bool waits(std::size_t place) const {
    return std::find(overwritten_.begin(), overwritten_.end(), place) != overwritten_.end();
  }

  Individual child_of(std::size_t place, RandomStream& random) const {
    const Individual& winner = kept()[place].individual;
    std::vector<std::size_t> used;
    return {0, task().breeder.child({&winner.genome, 1}, random, used), {winner.number}};
  }

  void do_tell(std::vector<ScoredIndividual> told) override {
    if (generation() == 0) {
      kept() = std::move(told);
      done_ = pairs_;
      return;
    }
    for (std::size_t i = 0; i < told.size(); ++i) kept()[overwritten_[i]] = std::move(told[i]);
    done_ = next_pair() + told.size();
  }

  bool generation_over() const override { return done_ == pairs_; }
  void do_save(SearchStateWriter& state) const override { state.add_count(done_); }
  void do_load(SearchStateReader& state) override {
    done_ = state.next_count();
    if (kept().size() != (generation() == 0 ? 0 : population_) || done_ > pairs_)
      throw Error("the stored state does not belong to a search with " + std::to_string(population_) +
                  " individuals and " + std::to_string(pairs_) + " pairs");
  }

  std::size_t population_, pairs_;
  std::size_t done_ = 0;                  // pairs with scores, of this generation or, if all, of the last
  std::vector<std::size_t> overwritten_;  // places for the individuals that were asked
};

}  // namespace

std::string PairedTournament::summary() const {
  return "Pairs drawn one after the other: a mutated copy of the fitter individual replaces the other";
}

ParameterDeclarations PairedTournament::parameters() const {
  return {{"population", "1", 100.0, 2.0, 1e6, Scale::linear, "Individuals"},
          {"pairs", "1", 75.0, 1.0, 1e6, Scale::linear, "Pairs per generation, drawn one after the other"},
          {"generations", "1", 20.0, 1.0, 1e6, Scale::linear, "Generations, including the random one"}};
}

std::unique_ptr<Search> PairedTournament::begin(const SearchTask& task, std::span<const double> parameters) const {
  const ParameterDeclarations declared = this->parameters();
  const auto count = [&](Parameter which) { return count_parameter(declared[which], parameters[which]); };
  return std::make_unique<PairedTournamentSearch>(task, count(kPopulation), count(kPairs), count(kGenerations));
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::SearchStrategy, lacuna::PairedTournament>("paired_tournament"))
