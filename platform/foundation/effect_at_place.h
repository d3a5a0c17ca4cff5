#pragma once

#include <string>

namespace lacuna {

/// An effect and where it acts.
struct EffectAtPlace {
  std::string effect;
  std::string place;  ///< "joint.hinge"; "world" for one that acts on no element
  bool operator==(const EffectAtPlace&) const = default;
};

/// As rankings and the database name it: "coulomb_friction @ joint.hinge".
std::string to_string(const EffectAtPlace& effect);
/// Reads what `to_string` wrote; without a place where there is none.
EffectAtPlace effect_at_place_from(const std::string& text);

}  // namespace lacuna
