#pragma once

#include <lacuna/model_encoding.h>

namespace lacuna {

/// One real gene a free parameter: the value itself, SI, within its search bounds. Decoding clamps to the bounds.
class Parameters : public ModelEncoding {
 public:
  std::string summary() const override;
  GenomeLayout layout(const ModelSpace& space, std::span<const double> parameters) const override;
  ModelProposal decode(const ModelSpace& space, std::span<const double> parameters,
                       std::span<const double> genome) const override;
};

}  // namespace lacuna
