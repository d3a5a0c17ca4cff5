#pragma once

#include "search/effect_look.h"
#include "search/fitted_models.h"

#include <optional>

namespace lacuna {

/// An answer whose effects stand on every joint (or body, actuator, sensor) where the data tell them, each with values
/// of its own: friction of an arm is friction of all of its joints. An effect on all joints at once is replaced by one
/// on each. Nothing where that is no better: it must gain more than its error where it was not fitted, by the signs of
/// the blocks and at more than one length, and a hundredth of `whole_gain`, nats, for each told value.
std::optional<FittedModel> spread_over_places(FittedModels& models, const EffectLook& look, const FittedModel& answer,
                                              double whole_gain);

}  // namespace lacuna
