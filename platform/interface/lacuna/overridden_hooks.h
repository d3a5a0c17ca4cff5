#pragma once

#include <lacuna/physical_effect.h>

#include <type_traits>

namespace lacuna {

/// Whether a class overrides a hook, told by the class that its member belongs to: `&Effect::before_step` is a member
/// of `PhysicalEffect` unless the class, or one between the two, has its own.
template <class Effect, class Own, class Result, class... Arguments>
consteval bool overrides(Own, Result (PhysicalEffect::*)(Arguments...) const) {
  static_assert(std::is_convertible_v<Own, Result (Effect::*)(Arguments...) const>,
                "a hook of this effect has other arguments than PhysicalEffect's and would never be called: write "
                "`override` behind it and take the arguments from lacuna/physical_effect.h");
  return !std::is_same_v<Own, Result (PhysicalEffect::*)(Arguments...) const>;
}

/// Whether the hooks of a class can be looked at: they are public, and none is overloaded.
template <class Effect>
concept HooksVisible = requires {
  &Effect::amend;
  &Effect::before_step;
  &Effect::after_step;
  &Effect::command;
  &Effect::sense;
};

/// Which hooks the class overrides.
template <class Effect>
consteval OverriddenHooks overridden_hooks() {
  static_assert(HooksVisible<Effect>,
                "the hooks amend, before_step, after_step, command and sense of an effect must be public and not "
                "overloaded, so that Lacuna sees which of them it overrides");
  if constexpr (HooksVisible<Effect>)
    return {.amend = overrides<Effect>(&Effect::amend, &PhysicalEffect::amend),
            .before_step = overrides<Effect>(&Effect::before_step, &PhysicalEffect::before_step),
            .after_step = overrides<Effect>(&Effect::after_step, &PhysicalEffect::after_step),
            .command = overrides<Effect>(&Effect::command, &PhysicalEffect::command),
            .sense = overrides<Effect>(&Effect::sense, &PhysicalEffect::sense)};
  else
    return {};
}

}  // namespace lacuna
