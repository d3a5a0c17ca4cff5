#pragma once

#include <lacuna/mutation_operator.h>

namespace lacuna {

/// Adds a normal number to each gene with a probability of `expected` over the number of genes; reflected at the
/// bounds.
class Gaussian : public MutationOperator {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  Genome vary(std::span<const Genome> parents, const GenomeLayout& layout, std::span<const double> parameters,
              RandomStream& random) const override;
};

}  // namespace lacuna
