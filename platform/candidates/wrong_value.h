#pragma once

#include "config/schema/experiment.h"
#include "evaluation/model/model_definition.h"

#include <string>
#include <vector>

namespace lacuna {

/// What the file of a robot may state wrongly stands beside effects under this name, at the address of the value:
/// `wrong_value @ joint.hinge.armature`. No effect is added then; the value is fitted.
inline constexpr const char* kWrongValue = "wrong_value";

bool is_wrong_value(const EffectEntry& entry);

/// The robot's fixed numbers of `base`, each with the range in which it is looked for: a tenth to ten times a positive
/// one, from 0 where that is possible, three times as far from one that may change its sign, within its physical
/// bounds. A number that stands for nothing (0, a factor of 1, no limit) is none: effects of the library say what is
/// missing there. Noise, contact and gravity stay as they are.
std::vector<EffectEntry> wrong_values(const ModelDefinition& base);

/// What an experiment file says of it.
FreeRange free_range(const EffectEntry& entry);

/// The experiment with the value that `entry` names fitted, too.
Experiment with_free_value(Experiment experiment, const EffectEntry& entry);

/// Whether a fitted value belongs to an entry: to an effect's parameters, or as the value that may be wrong.
bool belongs_to(const FreeValue& free, const EffectEntry& entry);

/// The last part of an address: "torque" of `effect.friction.torque`, "xx" of `body.arm.inertia.xx`.
std::string last_name(const std::string& address);

}  // namespace lacuna
