#include "dirty/dirty_kind.h"

#include "cases/scales_of.h"
#include "dirty/other_laws.h"
#include "laws/joint_law.h"

#include <algorithm>
#include <stdexcept>

namespace hidden_effects::dirty {
namespace {

using Names = std::vector<std::string>;

const Names kDry = {"coulomb_friction", "stribeck_friction", "lugre_friction", "hysteresis", "directional_friction"};
const Names kWay = {"position_friction", "coulomb_friction", "stribeck_friction",
                    "lugre_friction",    "hysteresis",       "directional_friction"};
const Names kViscous = {"viscous_friction", "linear_drag", "directional_viscous_friction", "torque_speed_line"};
const Names kThinning = {"viscous_friction", "linear_drag", "directional_viscous_friction", "coulomb_friction",
                         "torque_speed_line"};
const Names kBetween = {"viscous_friction", "linear_drag", "directional_viscous_friction", "quadratic_drag",
                        "quadratic_damping"};
const Names kLoad = {"load_friction", "gear_efficiency"};
const Names kHardening = {"cubic_stiffness", "joint_spring", "hard_stop"};
const Names kOffset = {"joint_offset_torque", "command_offset", "mount_tilt", "directional_friction"};
const Names kLate = {"command_delay", "actuator_lag", "sensor_delay", "sensor_lag"};
const Names kWeaker = {"supply_sag", "torque_saturation", "thermal_fade", "torque_gain", "command_bend"};

/// s, the time scale of a motion.
double time_of(const Scales& at) { return at.position / at.velocity; }

/// A law of the benchmark's library, with its own sizes.
LawKind known(const char* name) { return law_kind(name); }

template <class AtSize>
LawKind resized(const char* name, AtSize at_size) {
  LawKind law = law_kind(name);
  law.at_size = at_size;
  return law;
}

LawKind late(const char* name) {
  return resized(name, [](double size, const Scales& at, const Shape&) { return Values{0.05 * size * time_of(at)}; });
}

std::vector<DirtyKind> joint_kinds() {
  return {
      {known("coulomb_friction"), kDry, 1.0},
      {known("viscous_friction"), kViscous, 1.0},
      {known("thinning_viscous_friction"), kThinning, 0.5},
      {known("stribeck_friction"), kDry, 0.6},
      {known("load_friction"), kLoad, 0.7},
      {known("directional_friction"), kDry, 0.5},
      {known("position_friction"), kWay, 0.4},
      {known("lugre_friction"), kDry, 0.4},
      {known("hysteresis"), {"hysteresis", "lugre_friction", "coulomb_friction", "stribeck_friction"}, 0.5},
      {known("joint_spring"), {"joint_spring", "cubic_stiffness"}, 0.6},
      {known("cubic_stiffness"), kHardening, 0.5},
      {known("rubber_spring"), kHardening, 0.5},
      {known("hard_stop"), {"hard_stop", "cubic_stiffness"}, 0.3},
      {known("armature"), {"armature", "payload"}, 0.6},
      {known("cogging"), {"cogging"}, 0.4},
      {known("joint_offset_torque"), kOffset, 0.6},
  };
}

std::vector<DirtyKind> body_kinds() {
  return {
      {known("quadratic_drag"), {"quadratic_drag"}, 0.8},
      {known("rough_drag"), {"quadratic_drag", "linear_drag", "viscous_friction"}, 0.8},
      {known("linear_drag"), {"linear_drag", "viscous_friction", "directional_viscous_friction"}, 0.6},
      {known("payload"), {"payload", "armature"}, 0.7},
      {known("buoyancy"), {"buoyancy", "payload"}, 0.3},
      {known("mount_tilt"), {"mount_tilt", "joint_offset_torque", "command_offset", "sensor_offset"}, 0.3},
  };
}

std::vector<DirtyKind> drive_kinds() {
  return {
      {late("command_delay"), kLate, 0.8},
      {late("jittered_delay"), kLate, 0.4},
      {late("actuator_lag"), kLate, 0.6},
      {late("twofold_lag"), kLate, 0.5},
      {known("command_offset"), kOffset, 0.4},
      {known("torque_saturation"), {"torque_saturation", "supply_sag"}, 0.4},
      {known("torque_gain"), {"torque_gain", "sensor_scale", "armature", "payload"}, 0.4},
      {known("dead_zone"), {"dead_zone"}, 0.5},
      {known("soft_dead_zone"), {"dead_zone"}, 0.4},
      {known("thermal_fade"), {"thermal_fade", "torque_gain", "supply_sag"}, 0.4},
      {resized("joint_compliance",
               [](double size, const Scales& at, const Shape& u) {
                 const double reduced = 1.0 / (1.0 / at.rotor + 1.0 / at.inertia);
                 const double rate = between(12.0, 25.0, u[0]) / (time_of(at) * std::sqrt(std::max(size, 0.05)));
                 return Values{reduced * rate * rate, 2.0 * between(0.03, 0.1, u[1]) * reduced * rate};
               }),
       {"joint_compliance", "backlash", "link_flexibility"},
       0.4,
       8},
      {resized("backlash",
               [](double size, const Scales& at, const Shape& u) {
                 const double reduced = 1.0 / (1.0 / at.rotor + 1.0 / at.inertia);
                 const double rate = between(25.0, 40.0, u[0]) / time_of(at);
                 return Values{0.02 * size * at.position, reduced * rate * rate, 0.4 * reduced * rate};
               }),
       {"backlash", "joint_compliance", "hysteresis", "encoder_backlash"},
       0.4,
       10},
  };
}

std::vector<DirtyKind> sensor_kinds() {
  return {
      {late("sensor_delay"), kLate, 0.5, 1, true},
      {late("sensor_lag"), kLate, 0.3, 1, true},
      {late("butterworth_lag"), kLate, 0.3, 1, true},
      {known("sensor_offset"), {"sensor_offset", "mount_tilt", "joint_offset_torque", "command_offset"}, 0.3, 1, true},
      {known("sensor_scale"), {"sensor_scale"}, 0.3, 1, true},
      {known("encoder_eccentricity"), {"encoder_eccentricity"}, 0.3, 1, true},
  };
}

std::vector<DirtyKind> other_kinds() {
  const std::vector<std::pair<const char*, DirtyKind>> about = {
      {"smooth_dry_friction", {{}, kDry, 1.5}},
      {"stribeck_power_friction", {{}, kDry, 1.0}},
      {"drag_between_powers", {{}, kBetween, 1.2}},
      {"way_friction", {{}, kWay, 0.8}},
      {"load_power_friction", {{}, kLoad, 0.8}},
      {"spring_with_play", {{}, {"joint_spring", "cubic_stiffness", "hard_stop"}, 0.8}},
      {"cable_spring", {{}, {"cubic_stiffness", "joint_spring", "hard_stop", "joint_offset_torque"}, 0.5}},
      {"saturating_iron", {{}, kWeaker, 0.9}},
      {"second_order_lag", {{}, kLate, 0.8}},
  };
  std::vector<DirtyKind> kinds;
  for (const auto& laws : {other_friction_laws(), other_spring_laws(), other_drive_laws()})
    for (const LawKind& law : laws)
      for (const auto& [name, kind] : about)
        if (law.name == name) kinds.push_back(kind), kinds.back().law = law;
  return kinds;
}

/// Real laws seldom have the library's form: its own are drawn this much less often.
constexpr double kLibraryForms = 0.4;

/// What would be odd before it is large: a link that half floats, a motor of twice the torque, a bench that lies down.
constexpr std::pair<const char*, double> kMostSizes[] = {
    {"buoyancy", 3.0},     {"mount_tilt", 5.0},          {"torque_gain", 6.0},
    {"sensor_scale", 4.0}, {"sensor_offset", 4.0},       {"encoder_eccentricity", 4.0},
    {"hard_stop", 3.5},    {"joint_offset_torque", 5.0}, {"command_offset", 5.0}};

}  // namespace

const std::vector<DirtyKind>& dirty_kinds() {
  static const std::vector<DirtyKind> all = [] {
    std::vector<DirtyKind> kinds;
    for (const auto& part : {joint_kinds(), body_kinds(), drive_kinds(), sensor_kinds(), other_kinds()})
      kinds.insert(kinds.end(), part.begin(), part.end());
    for (DirtyKind& kind : kinds)
      if (kind.law.library_form) kind.weight *= kLibraryForms;
    for (DirtyKind& kind : kinds)
      for (const auto& [name, most] : kMostSizes)
        if (kind.law.name == name) kind.most_size = most;
    return kinds;
  }();
  return all;
}

const DirtyKind& dirty_kind(const std::string& name) {
  for (const DirtyKind& kind : dirty_kinds())
    if (kind.law.name == name) return kind;
  throw std::invalid_argument("no dirty law is called " + name);
}

}  // namespace hidden_effects::dirty
