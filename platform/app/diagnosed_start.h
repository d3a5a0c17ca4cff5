#pragma once

#include "app/options.h"
#include "app/rig.h"

#include <map>
#include <string>

namespace lacuna {

/// Start values for an effect of `extended` from what a diagnosis of `base`, or of a model that it was made from, found
/// for that effect in that place: to four digits, within their bounds, by parameter. Empty where the database has none,
/// or the effect acts on several elements.
std::map<std::string, double> diagnosed_start(const CommonOptions& options, const Rig& base, const Rig& extended,
                                              const EffectEntry& entry);

}  // namespace lacuna
