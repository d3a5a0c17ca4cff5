#pragma once

#include <lacuna/mutation_operator.h>

namespace lacuna {

/// Mutates genomes of `morphology` as a robot's shape instead of as numbers: attaches a part elsewhere, moves a part's
/// centre or changes the first part's length, and turns and stretches the other parts so that their centres stay, as
/// far as genes allow. Readings of position sensors of the other parts then stay the same.
class Reshape : public MutationOperator {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  /// Throws `Error` for a layout without two rows of a length and five genes from 0 to 1, and for decades in the wrong
  /// order. Lengths keep their genes' bounds.
  Genome vary(std::span<const Genome> parents, const GenomeLayout& layout, std::span<const double> parameters,
              RandomStream& random) const override;
};

}  // namespace lacuna
