#pragma once

#include <lacuna/model_encoding.h>

#include "evaluation/model_definition.h"

#include <cstddef>
#include <span>
#include <vector>

namespace lacuna {

/// The effects of a definition as encodings see them, in its order; `ModelSpace::free` are the definition's.
std::vector<ModelEffect> model_effects(const ModelDefinition& definition);

/// What is compiled for a proposal: its robot, or the definition's, with the effects that it has and the parameters of
/// these alone, so that an effect that is left out changes nothing, bit for bit.
ModelStructure structure_of(const ModelProposal& proposal, const ModelDefinition& definition);

/// Which of a proposal's values, as indices, are those of that structure's parameters, in their order.
std::vector<std::size_t> kept_values(const ModelProposal& proposal, const ModelDefinition& definition);

/// Those values.
std::vector<double> structure_values(const ModelProposal& proposal, const ModelDefinition& definition);

}  // namespace lacuna
