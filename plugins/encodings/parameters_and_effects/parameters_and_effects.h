#pragma once

#include <lacuna/model_encoding.h>

namespace lacuna {

/// Values and switches: one real gene a free parameter, as the encoding `parameters` has it, then one from 0 to 1 an
/// optional effect, which is on where its gene is above 0.5. Models with other effects on are rival hypotheses.
class ParametersAndEffects : public ModelEncoding {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  /// Throws `Error` where no effect is optional, a parameter has no finite bounds, or `at_most` is no whole number.
  GenomeLayout layout(const ModelSpace& space, std::span<const double> parameters) const override;
  /// `structure` names the optional effects that are on, in the model's order.
  ModelProposal decode(const ModelSpace& space, std::span<const double> parameters,
                       std::span<const double> genome) const override;
};

}  // namespace lacuna
