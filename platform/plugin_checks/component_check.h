#pragma once

#include "foundation/processes/guarded_call.h"
#include "plugin_checks/check_result.h"
#include "plugin_checks/exercise.h"

#include <lacuna/plugin.h>

#include <string>
#include <vector>

namespace lacuna {

/// The checks of a component, in their order.
const std::vector<std::string>& component_check_names();

/// Carries out one of them on a component that is made now. In a process that only tries plugins, for it may not
/// survive it; everything that is thrown becomes a failure.
CheckResult check_component(const ComponentEntry& component, const ComponentOrigin& origin, const std::string& check,
                            const ExerciseInputs& inputs);

/// Of all numbers that the component gives in its exercise: what another process is to give as well. Empty where it has
/// none to compare. Throws what the component throws.
std::string transcript_digest(const ComponentEntry& component, const ComponentOrigin& origin,
                              const ExerciseInputs& inputs);

}  // namespace lacuna
