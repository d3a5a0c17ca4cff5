#pragma once

#include "config/schema/experiment.h"
#include "evaluation/model/model_definition.h"

#include <string>
#include <vector>

namespace lacuna {

/// Name under which a fixed value that may be wrong stands among the effects, with its address as place: `wrong_value @
/// joint.hinge.armature`. Instead of adding an effect, the value is fitted.
inline constexpr const char* kWrongValue = "wrong_value";

bool is_wrong_value(const EffectEntry& entry);

/// The robot's fixed numbers of `base` that may be wrong, each with its search range: a tenth to ten times a positive
/// one (from 0 where 0 is possible), three times as far from one that may change its sign, within its physical bounds.
/// A number that switches something off (0, a factor of 1, no limit) is left out: effects of the library cover that
/// case. Noise, contact and gravity stay fixed.
std::vector<EffectEntry> wrong_values(const ModelDefinition& base);

/// The entry of the experiment file for it.
FreeRange free_range(const EffectEntry& entry);

/// The experiment with the value of `entry` fitted, too.
Experiment with_free_value(Experiment experiment, const EffectEntry& entry);

/// Whether a fitted value belongs to an entry: it is a parameter of its effect or the value that may be wrong.
bool belongs_to(const FreeValue& free, const EffectEntry& entry);

/// The last part of an address: "torque" of `effect.friction.torque`, "xx" of `body.arm.inertia.xx`.
std::string last_name(const std::string& address);

}  // namespace lacuna
