#pragma once

#include <lacuna/error.h>
#include <lacuna/search_state.h>
#include <lacuna/search_strategy.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace lacuna {

/// Common part of most searches, for authors of search plugins: counting, numbering, checking, saving. A derived search
/// chooses the next genomes (`do_ask`), uses their scores (`do_tell`), and holds its best individuals in `kept()`. All
/// random numbers come from `stream(index)`, so that asking again after `load` gives the same.
class GenerationalSearch : public Search {
 public:
  /// `task` is copied; what it refers to must outlive the search.
  GenerationalSearch(const SearchTask& task, std::size_t generations) : task_(task), generations_(generations) {}

  bool finished() const final { return generation_ >= generations_; }
  int generation() const final { return static_cast<int>(generation_); }
  int generations() const final { return static_cast<int>(generations_); }

  const std::vector<Individual>& ask() final {
    if (!asked_.empty() || finished()) return asked_;
    asked_ = do_ask();
    for (std::size_t i = 0; i < asked_.size(); ++i) asked_[i].number = numbered_ + i;
    return asked_;
  }

  /// NaN counts as infinite. Throws `Error` where the number of scores is not that of the individuals asked.
  void tell(std::span<const double> scores) final {
    if (asked_.empty() || scores.size() != asked_.size())
      throw Error("the search received " + std::to_string(scores.size()) + " scores; it asked for " +
                  std::to_string(asked_.size()));
    std::vector<ScoredIndividual> told;
    for (std::size_t i = 0; i < scores.size(); ++i)
      told.push_back(
          {std::move(asked_[i]), std::isnan(scores[i]) ? std::numeric_limits<double>::infinity() : scores[i]});
    asked_.clear();
    do_tell(std::move(told));
    numbered_ += scores.size();
    if (generation_over()) ++generation_;
  }

  std::vector<ScoredIndividual> best() const final {
    std::vector<ScoredIndividual> sorted = kept_;
    std::sort(sorted.begin(), sorted.end(), better);
    return sorted;
  }

  std::vector<double> save() const final {
    SearchStateWriter state;
    state.add_count(generation_);
    state.add_count(numbered_);
    state.add_all(kept_);
    do_save(state);
    return state.take();
  }

  void load(std::span<const double> state) final {
    SearchStateReader reader(state);
    generation_ = reader.next_count();
    numbered_ = reader.next_count();
    kept_ = reader.next_individuals(task_.layout.size());
    do_load(reader);
    reader.finish();
    asked_.clear();
  }

 protected:
  const SearchTask& task() const { return task_; }
  /// In any order; `best` sorts a copy.
  const std::vector<ScoredIndividual>& kept() const { return kept_; }
  std::vector<ScoredIndividual>& kept() { return kept_; }
  /// The random numbers of an individual: of the task's key, the generation and the individual's index in it.
  RandomStream stream(std::size_t index) const {
    std::vector<std::uint64_t> key = task_.key;
    key.insert(key.end(), {generation_, index});
    return RandomStream(key);
  }
  /// A genome of the first generation: the seeds first, then random genomes.
  Genome first_genome(std::size_t index) const {
    RandomStream random = stream(index);
    return index < task_.seeds.size() ? task_.seeds[index] : task_.breeder.random(random);
  }
  /// Of two individuals with the same score the older one is better.
  static bool better(const ScoredIndividual& a, const ScoredIndividual& b) {
    return a.score != b.score ? a.score < b.score : a.individual.number < b.individual.number;
  }

 private:
  /// The next individuals, at least one; their numbers are filled in.
  virtual std::vector<Individual> do_ask() = 0;
  /// The same individuals with their scores, none of them NaN.
  virtual void do_tell(std::vector<ScoredIndividual> told) = 0;
  /// Whether `do_tell` has completed the generation. A search whose individuals depend on scores of others asks for one
  /// generation in parts.
  virtual bool generation_over() const { return true; }
  /// The memory of a search besides `kept()`.
  virtual void do_save(SearchStateWriter&) const {}
  virtual void do_load(SearchStateReader&) {}

  SearchTask task_;
  std::uint64_t generations_;
  std::uint64_t generation_ = 0;
  std::uint64_t numbered_ = 0;  // individuals in earlier generations
  std::vector<ScoredIndividual> kept_;
  std::vector<Individual> asked_;
};

}  // namespace lacuna
