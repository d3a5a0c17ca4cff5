#pragma once

#include <lacuna/parameter.h>
#include <lacuna/physical_effect.h>

#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

/// What is wrong with the parameters that a component declares: names, units, bounds, defaults. Empty: nothing; else
/// the first fault and what to do about it.
std::string declaration_problem(const ParameterDeclarations& parameters);

/// The same for the endings of files that a format reads; `taken` is what the host reads itself.
std::string endings_problem(const std::vector<std::string>& endings, std::string_view taken);

/// The same for what an effect says of itself: its parameters with units that may depend on the placement, its
/// placements and neutral values, and the stages of the hooks that it overrides.
std::string effect_problem(const EffectDescription& description, const EffectStages& stages,
                           const OverriddenHooks& overridden);

}  // namespace lacuna
