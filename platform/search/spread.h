#pragma once

#include "search/effect_look.h"
#include "search/fitted_models.h"

#include <optional>

namespace lacuna {

/// The answer with its effects on every joint (or body, actuator, sensor) where the data determine them, with separate
/// values on each: friction of an arm is friction in all of its joints. An effect with one value for all joints is
/// replaced by one on each. Nothing where that is not better: it must gain more than its error on data to which it was
/// not fitted, by the signs of the blocks and at more than one length, and a hundredth of `whole_gain`, nats, for each
/// such value.
std::optional<FittedModel> spread_over_places(FittedModels& models, const EffectLook& look, const FittedModel& answer,
                                              double whole_gain);

}  // namespace lacuna
