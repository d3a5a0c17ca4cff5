#pragma once

#include "plant/law.h"

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace hidden_effects {

/// What an effect stands on; the words of the library's `where`.
enum class Place { joint, body, drive, sensor, world };

/// How many elements there are; 1 of the world.
int elements_of(const PlantSpec& spec, Place place);

/// In the place of an element: all of them, with the same parameters, as the library's `joint.*`.
inline constexpr int kEverywhere = -1;

/// How large things are in the motion of a rig that hides nothing, at one place. SI, all positive.
struct Scales {
  double force = 1.0;  ///< RMS of what drives the joint, N·m or N
  double peak_force = 1.0;
  double position = 1.0;                ///< half of the range, rad or m
  double lowest = -1.0, highest = 1.0;  ///< of the position
  double velocity = 1.0;                ///< which 95 % of the samples stay below
  double inertia = 1.0;                 ///< that the joint moves, kg·m² or kg
  double mass = 1.0;                    ///< of the body on it, kg
  double lever = 1.0;                   ///< from the joint to the body's centre of mass, m; 1 on a slider
  double command = 1.0;                 ///< RMS, in its unit
  double peak_command = 1.0;
  double rotor = 0.1;     ///< inertia of the rotor at the joint
  double duration = 5.0;  ///< of a trial, s
};

/// Numbers in [0, 1) that draw the shape of a law, once a case.
using Shape = std::array<double, 8>;

/// A law that a case can hide or the oracle try.
struct LawKind {
  std::string name;    ///< unique: that of the effect, or of a form that the library does not have
  std::string effect;  ///< of the library: the answer that is right
  Place place = Place::joint;
  bool library_form = true;
  std::vector<std::string>
      parameters;  ///< named like the effect's; those that a case leaves at the default are not here
  std::shared_ptr<const Law> (*make)(std::span<const double> values, int element) = nullptr;

  /// The parameters at a size ≥ 0 that a search varies: 0 changes nothing, 1 is about a tenth of the forces at work.
  std::vector<double> (*at_size)(double size, const Scales& scales, const Shape& shape) = nullptr;

  /// Whether neither position nor velocity, nor a slider or hinge, makes it senseless there.
  bool (*applies)(const PlantSpec& spec, int element) = nullptr;

  std::vector<std::string> even = {};  ///< parameters whose sign changes nothing; they are told by their size
};

/// All laws, by family.
std::vector<LawKind> friction_laws();
std::vector<LawKind> joint_laws();
std::vector<LawKind> body_laws();
std::vector<LawKind> drive_laws();
std::vector<LawKind> sensor_laws();
const std::vector<LawKind>& all_laws();

bool is_even(const LawKind& kind, const std::string& parameter);

/// The one of that name; throws `std::invalid_argument`.
const LawKind& law_kind(const std::string& name);

}  // namespace hidden_effects
