#pragma once

#include <lacuna/genome.h>
#include <lacuna/parameter.h>
#include <lacuna/random_stream.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// The host's services for a search: genomes of the current encoding.
class Breeder {
 public:
  virtual ~Breeder() = default;
  virtual Genome random(RandomStream& random) const = 0;
  /// A child of some random members of `parents`, by the experiment's mutation operators. `used` receives the indices
  /// of its parents.
  virtual Genome child(std::span<const Genome> parents, RandomStream& random, std::vector<std::size_t>& used) const = 0;
};

/// The task of a search. Layout and breeder must outlive the search.
struct SearchTask {
  const GenomeLayout& layout;
  const Breeder& breeder;
  std::vector<std::uint64_t> key;  ///< of all random streams of the search; a search adds generation and individual
  std::vector<Genome> seeds;       ///< good genomes to start from; may be empty
};

/// A genome and its origin.
struct Individual {
  std::uint64_t number = 0;  ///< numbered through the whole search
  Genome genome;
  std::vector<std::uint64_t> parents;  ///< numbers
};

struct ScoredIndividual {
  Individual individual;
  double score = 0.0;
};

/// A search in progress. Smaller scores are better; infinite ones are invalid. Used by one thread at a time.
class Search {
 public:
  virtual ~Search() = default;

  virtual bool finished() const = 0;
  /// The next individuals of this generation without a score: all of them, or those that do not depend on scores of
  /// others.
  virtual const std::vector<Individual>& ask() = 0;
  /// A score above this limit cannot change the result of the generation; fixed when the individuals are asked.
  /// Nothing: every score counts in full.
  virtual std::optional<double> abandon_above() const { return std::nullopt; }
  /// One score for each individual asked; ends the generation when all of its individuals have one. For an evaluation
  /// that was abandoned, pass any number above the limit.
  virtual void tell(std::span<const double> scores) = 0;
  /// The best individuals so far, best first, as many as the search keeps; their scores.
  virtual std::vector<ScoredIndividual> best() const = 0;
  /// Generations completed so far, and the largest number of generations.
  virtual int generation() const = 0;
  virtual int generations() const = 0;
  /// The state between `tell` and `ask` as numbers, and back: continuing gives the same digits.
  virtual std::vector<double> save() const = 0;
  virtual void load(std::span<const double> state) = 0;
};

/// Makes searches. Const and shared by threads.
class SearchStrategy {
 public:
  virtual ~SearchStrategy() = default;

  /// One sentence for `lacuna plugins`.
  virtual std::string summary() const = 0;
  /// Population, generations and the like.
  virtual ParameterDeclarations parameters() const { return {}; }
  /// Throws `Error` for parameters with which no search is possible.
  virtual std::unique_ptr<Search> begin(const SearchTask& task, std::span<const double> parameters) const = 0;
};

}  // namespace lacuna
