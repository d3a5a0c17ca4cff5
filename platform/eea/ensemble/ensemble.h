#pragma once

#include "eea/definition/eea_state.h"
#include "evaluation/scoring/phenotypes.h"

#include <cstddef>
#include <vector>

namespace lacuna {

/// Chooses `count` different models from models sorted best first, as indices: the best of each structure and restart,
/// best first, then the best of the others; copies that no simulation can distinguish come last. Fewer where there are
/// fewer.
std::vector<std::size_t> differing(const std::vector<KnownModel>& models, std::size_t count,
                                   const Phenotypes& phenotypes);

}  // namespace lacuna
