#pragma once

#include "dirty/dirty_rig.h"
#include "laws/law_kind.h"

#include <string>
#include <vector>

namespace hidden_effects::dirty {

/// A law that a dirty case can hide. `law.at_size` is scaled by the motion itself, times included: 1 is about a tenth
/// of the forces at work, or a delay of a twentieth of the motion's time scale.
struct DirtyKind {
  LawKind law;
  std::vector<std::string> accepted;  ///< effects of the library that name it, at the places of its joint
  double weight = 1.0;                ///< how often it is drawn as a main effect
  int finer = 1;                      ///< integration steps that it needs over those of the rig
  bool reading = false;               ///< an error of a sensor that counts as a reading error where it is small
  double most_size = 8.0;             ///< beyond it the law is no longer one of several things that a rig does
};

/// What the force of a kind goes with: for each quantity the words of an answer that name it ("position",
/// "velocity, by the position", see residual_law/law_family.h); any of them is right. Empty: the kind is no force that
/// could be told from a position, a velocity, a command or a time, such as an inertia, a constant or a reading's error.
/// Fixed before any method was asked.
std::vector<std::string> goes_with(const DirtyKind& kind);

/// All effects of the library that could stand for a kind, near ones with them: withheld, nothing names it.
std::vector<std::string> effects_like(const DirtyKind& kind);

/// All of them. The accepted names were fixed before any method was asked.
const std::vector<DirtyKind>& dirty_kinds();

/// The one of that name; throws `std::invalid_argument`.
const DirtyKind& dirty_kind(const std::string& name);

/// A kind at a joint, body, drive or sensor.
struct PlacedKind {
  const DirtyKind* kind = nullptr;
  int element = 0;
};

/// What makes sense on a rig, each at each of its places.
std::vector<PlacedKind> placed_kinds(const DirtyRig& rig);

/// "coulomb_friction @ joint.hinge" of each accepted name, at all places of one joint where it can stand.
std::vector<std::string> accepted_at(const std::vector<std::string>& effects, const PlantSpec& spec, int joint);

/// The same of a wrong value of the robot file, beside "value body.arm.mass". `factor`: the truth over what is stated.
std::vector<std::string> accepted_for(const RobotValue& value, double factor, const PlantSpec& spec);

/// "joint.hinge"; "world".
std::string place_text(const DirtyKind& kind, int element, const PlantSpec& spec);

}  // namespace hidden_effects::dirty
