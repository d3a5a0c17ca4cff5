#pragma once

#include "eea/definition/eea_state.h"
#include "evaluation/scoring/phenotypes.h"

#include <cstddef>
#include <vector>

namespace lacuna {

/// Of models that are sorted, best first, `count` that differ, as indices: the best of each structure and restart, best
/// first, then the best of those that are left, copies that no simulation tells apart last. Fewer where there are
/// fewer.
std::vector<std::size_t> differing(const std::vector<KnownModel>& models, std::size_t count,
                                   const Phenotypes& phenotypes);

}  // namespace lacuna
