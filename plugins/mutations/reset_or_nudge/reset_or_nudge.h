#pragma once

#include <lacuna/mutation_operator.h>

namespace lacuna {

/// The mutation of the seed's experiment 2 (Eq. 2): one gene gets a new uniform value, or moves by ±range·10^−δ with δ
/// uniform in [`coarsest`, `finest`] decades. A move beyond a bound ends at it (`clip` = 1) or is reflected there (0).
class ResetOrNudge : public MutationOperator {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  /// Throws `Error` where the decades are the wrong way round, or `clip` is neither 0 nor 1.
  Genome vary(std::span<const Genome> parents, const GenomeLayout& layout, std::span<const double> parameters,
              RandomStream& random) const override;
};

}  // namespace lacuna
