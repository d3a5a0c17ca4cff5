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

/// Carries out one check on a new component. Runs in a process for trying plugins, because it may not survive;
/// everything that is thrown becomes a failure.
CheckResult check_component(const ComponentEntry& component, const ComponentOrigin& origin, const std::string& check,
                            const ExerciseInputs& inputs);

/// Digest of all numbers of the component in its exercise, for comparison with another process. Empty where there are
/// none. Throws what the component throws.
std::string transcript_digest(const ComponentEntry& component, const ComponentOrigin& origin,
                              const ExerciseInputs& inputs);

}  // namespace lacuna
