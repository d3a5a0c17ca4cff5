#pragma once

#include "app/terminal/options.h"
#include "app/workspace/open_experiment.h"
#include "foundation/effect_at_place.h"

#include <map>
#include <string>
#include <vector>

namespace lacuna {

/// Start values for an effect of `extended` from what a diagnosis of `base`, or of a model that it was made from, found
/// for that effect in that place: to four digits, within their bounds, by parameter. Empty where the database has none,
/// or the effect acts on several elements.
std::map<std::string, double> diagnosed_start(const CommonOptions& options, const OpenExperiment& base,
                                              const OpenExperiment& extended, const EffectEntry& entry);

/// What the latest diagnosis of `base` found to be missing; nothing where the database has no such diagnosis.
std::vector<EffectAtPlace> diagnosed_answer(const CommonOptions& options, const OpenExperiment& base);

}  // namespace lacuna
