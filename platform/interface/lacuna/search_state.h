#pragma once

#include <lacuna/error.h>
#include <lacuna/search_strategy.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace lacuna {

/// For `Search::save`: numbers one after the other. Counts and numbers of individuals are exact below 2⁵³.
class SearchStateWriter {
 public:
  void add(double value) { state_.push_back(value); }
  void add_count(std::uint64_t value) { state_.push_back(static_cast<double>(value)); }
  void add_all(std::span<const double> values) { state_.insert(state_.end(), values.begin(), values.end()); }
  void add_all(std::span<const ScoredIndividual> all) {
    add_count(all.size());
    for (const ScoredIndividual& one : all) {
      add(one.score);
      add_count(one.individual.number);
      add_count(one.individual.parents.size());
      for (const std::uint64_t parent : one.individual.parents) add_count(parent);
      add_all(one.individual.genome);
    }
  }
  std::vector<double> take() { return std::move(state_); }

 private:
  std::vector<double> state_;
};

/// For `Search::load`: the same numbers in the same order. Throws `Error` where there are fewer or more numbers than
/// are read.
class SearchStateReader {
 public:
  explicit SearchStateReader(std::span<const double> state) : rest_(state) {}

  double next() { return next(1).front(); }
  std::span<const double> next(std::size_t count) {
    if (count > rest_.size()) refuse();
    const std::span<const double> values = rest_.first(count);
    rest_ = rest_.subspan(count);
    return values;
  }
  std::uint64_t next_count() {
    const double value = next();
    if (!(value >= 0.0 && value < 0x1.0p53)) refuse();
    return static_cast<std::uint64_t>(value);
  }
  /// `genes`: the length of a genome.
  std::vector<ScoredIndividual> next_individuals(std::size_t genes) {
    const std::uint64_t count = next_count();
    if (count > rest_.size()) refuse();
    std::vector<ScoredIndividual> all(count);
    for (ScoredIndividual& one : all) {
      one.score = next();
      one.individual.number = next_count();
      const std::uint64_t parents = next_count();
      for (std::uint64_t i = 0; i < parents; ++i) one.individual.parents.push_back(next_count());
      const std::span<const double> genome = next(genes);
      one.individual.genome.assign(genome.begin(), genome.end());
    }
    return all;
  }
  /// Call this after the last read.
  void finish() const {
    if (!rest_.empty()) refuse();
  }

 private:
  [[noreturn]] static void refuse() {
    throw Error(
        "the stored state belongs to another search or other settings; begin the search anew, or use the settings it "
        "began with");
  }

  std::span<const double> rest_;
};

}  // namespace lacuna
