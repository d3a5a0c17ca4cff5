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

/// What is compiled for a proposal: its robot, or the definition's, with the effects that it has and the parameters of
/// these alone, so that an effect that is left out changes nothing, bit for bit.
ModelStructure structure_of(const ModelProposal& proposal, const ModelDefinition& definition);

/// Which of a proposal's values, as indices, are those of that structure's parameters, in their order.
std::vector<std::size_t> kept_values(const ModelProposal& proposal, const ModelDefinition& definition);

/// Those values.
std::vector<double> structure_values(const ModelProposal& proposal, const ModelDefinition& definition);

/// What is wrong with a proposal that an encoding made for that space, which wants a value for each of its free ones, a
/// robot that can take the place of its own, and all effects that are not optional. Empty: nothing.
std::string misfit(const ModelProposal& proposal, const ModelSpace& space);

}  // namespace lacuna
