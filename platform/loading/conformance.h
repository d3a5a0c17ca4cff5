#pragma once

#include <lacuna/parameter.h>
#include <lacuna/physical_effect.h>

#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

/// The first fault in the declared parameters of a component (names, units, bounds, defaults) and what to do about it.
/// Empty: none.
std::string declaration_problem(const ParameterDeclarations& parameters);

/// The same for the endings of files that a format reads; `taken` is the host's own ending.
std::string endings_problem(const std::vector<std::string>& endings, std::string_view taken);

/// The same for the description of an effect: its parameters with units that may depend on the placement, its
/// placements and neutral values, and the stages of the hooks that it overrides.
std::string effect_problem(const EffectDescription& description, const EffectStages& stages,
                           const OverriddenHooks& overridden);

}  // namespace lacuna
