#pragma once

#include "diagnosis/candidates/contender.h"

#include <string>
#include <vector>

namespace lacuna {

/// The models that have, in the place of one of the answer's effects, one that this declares as a look-alike and that
/// has fewer parameters. These begin at the mean of those of the same unit that they replace; all other values stay.
/// `plain`: the model without any effect added; `among`: names of effects; empty: all.
std::vector<Contender> with_simpler_effects(const Contender& answer, const Contender& plain,
                                            const PluginCatalog& catalog, const std::vector<std::string>& among);

}  // namespace lacuna
