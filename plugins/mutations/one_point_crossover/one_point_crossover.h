#pragma once

#include <lacuna/mutation_operator.h>

namespace lacuna {

/// The first genes of one parent and the rest of another, cut at a random place that is never inside a row.
class OnePointCrossover : public MutationOperator {
 public:
  std::string summary() const override;
  std::size_t parents() const override { return 2; }
  Genome vary(std::span<const Genome> parents, const GenomeLayout& layout, std::span<const double> parameters,
              RandomStream& random) const override;
};

}  // namespace lacuna
