#pragma once

#include <lacuna/mutation_operator.h>

namespace lacuna {

/// Gives each gene a new uniform value with a probability of `expected` over the number of genes.
class UniformReset : public MutationOperator {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  Genome vary(std::span<const Genome> parents, const GenomeLayout& layout, std::span<const double> parameters,
              RandomStream& random) const override;
};

}  // namespace lacuna
