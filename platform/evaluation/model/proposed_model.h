#pragma once

#include <lacuna/model_encoding.h>

#include "evaluation/model/model_definition.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// The effects of a definition as encodings see them, in its order; `ModelSpace::free` are the definition's.
std::vector<ModelEffect> model_effects(const ModelDefinition& definition);

/// The definition to compile for a proposal: its robot, or the definition's, with only its effects and their
/// parameters, so that an effect that is left out changes nothing, bit for bit.
ModelStructure structure_of(const ModelProposal& proposal, const ModelDefinition& definition);

/// Indices of those of a proposal's values that are parameters of that structure, in their order.
std::vector<std::size_t> kept_values(const ModelProposal& proposal, const ModelDefinition& definition);

/// Those values.
std::vector<double> structure_values(const ModelProposal& proposal, const ModelDefinition& definition);

/// The fault of a proposal from an encoding for that space. It needs a value for each free parameter, a robot that can
/// replace the space's own, and all effects that are not optional. Empty: none.
std::string misfit(const ModelProposal& proposal, const ModelSpace& space);

}  // namespace lacuna
