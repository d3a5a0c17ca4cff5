#pragma once

#include <lacuna/genome.h>
#include <lacuna/parameter.h>
#include <lacuna/random_stream.h>

#include <span>
#include <string>

namespace lacuna {

/// Makes a genome from one or more others. Const and shared by threads; the same arguments and stream give the same
/// child.
class MutationOperator {
 public:
  virtual ~MutationOperator() = default;

  /// One sentence for `lacuna plugins`.
  virtual std::string summary() const = 0;
  virtual ParameterDeclarations parameters() const { return {}; }
  /// Number of genomes from which a child is made; 2 for a crossover.
  virtual std::size_t parents() const { return 1; }
  /// `parents`: as many as `parents()` returns, each matching the layout. The child matches it, too.
  virtual Genome vary(std::span<const Genome> parents, const GenomeLayout& layout, std::span<const double> parameters,
                      RandomStream& random) const = 0;
};

}  // namespace lacuna
