#pragma once

#include <string>

namespace lacuna {

/// An effect and its place.
struct EffectAtPlace {
  std::string effect;
  std::string place;  ///< "joint.hinge"; "world" for an effect on no element
  bool operator==(const EffectAtPlace&) const = default;
};

/// As in rankings and the database: "coulomb_friction @ joint.hinge".
std::string to_string(const EffectAtPlace& effect);
/// The inverse of `to_string`; without a place where there is none.
EffectAtPlace effect_at_place_from(const std::string& text);

}  // namespace lacuna
