#pragma once

#include <lacuna/physical_effect.h>

#include <type_traits>

namespace lacuna {

/// Whether a class overrides a hook, determined by the class of its member: `&Effect::add_loads` is a member of
/// `PhysicalEffect` unless the class or a base class between the two overrides it.
template <class Effect, class Own, class Result, class... Arguments>
consteval bool overrides(Own, Result (PhysicalEffect::*)(Arguments...) const) {
  static_assert(std::is_convertible_v<Own, Result (Effect::*)(Arguments...) const>,
                "a hook of this effect has other arguments than PhysicalEffect's and would never be called: write "
                "`override` after it and take the arguments from lacuna/physical_effect.h");
  return !std::is_same_v<Own, Result (PhysicalEffect::*)(Arguments...) const>;
}

/// Whether the hooks of a class can be inspected: they are public, and none is overloaded.
template <class Effect>
concept HooksVisible = requires {
  &Effect::amend;
  &Effect::add_loads;
  &Effect::advance;
  &Effect::command;
  &Effect::sense;
};

/// Which hooks the class overrides.
template <class Effect>
consteval OverriddenHooks overridden_hooks() {
  static_assert(HooksVisible<Effect>,
                "the hooks amend, add_loads, advance, command and sense of an effect must be public and not "
                "overloaded, so that Lacuna sees which of them it overrides");
  if constexpr (HooksVisible<Effect>)
    return {.amend = overrides<Effect>(&Effect::amend, &PhysicalEffect::amend),
            .add_loads = overrides<Effect>(&Effect::add_loads, &PhysicalEffect::add_loads),
            .advance = overrides<Effect>(&Effect::advance, &PhysicalEffect::advance),
            .command = overrides<Effect>(&Effect::command, &PhysicalEffect::command),
            .sense = overrides<Effect>(&Effect::sense, &PhysicalEffect::sense)};
  else
    return {};
}

}  // namespace lacuna
