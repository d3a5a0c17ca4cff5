#include "cases/scales_of.h"
#include "dirty/dirty_kind.h"

#include <algorithm>
#include <initializer_list>

/// On which rigs a law is anything.
namespace hidden_effects::dirty {
namespace {

/// What is asked of a law before it may stand on a rig.
struct AskedPlace {
  const DirtyKind& kind;
  const DirtyRig& rig;
  int element;

  const std::string& name() const { return kind.law.name; }
  const std::string& effect() const { return kind.law.effect; }
  int joint() const { return joint_of(rig.stated, kind.law.place, element); }
  bool is_hinge() const { return !rig.stated.joints[static_cast<std::size_t>(joint())].slides; }
  bool turns_about_com() const {
    return is_hinge() && rig.stated.bodies[static_cast<std::size_t>(joint())].com.norm() == 0.0;
  }
  bool is_of_speed() const {
    return kind.law.place == Place::sensor && rig.stated.sensors[static_cast<std::size_t>(element)].velocity;
  }
  bool is_one_of(std::initializer_list<const char*> names, const std::string& asked) const {
    return std::any_of(names.begin(), names.end(), [&](const char* one) { return asked == one; });
  }
};

/// Of bodies and the world: a drag of an axle's own centre moves nothing, and air is nothing beside gears.
bool body_makes_sense(const AskedPlace& at) {
  if (at.kind.law.place == Place::body && at.turns_about_com()) return false;
  if (at.name() == "mount_tilt" && (!at.is_hinge() || at.turns_about_com())) return false;
  const bool has_gears = at.rig.driving == Driving::servo || at.rig.driving == Driving::position_loop;
  return !has_gears || !at.name().ends_with("drag");
}

/// Nothing tells late readings of a rig that nothing drives.
bool sensor_makes_sense(const AskedPlace& at) {
  if (at.kind.law.place != Place::sensor) return true;
  if (at.is_of_speed() && !at.is_one_of({"sensor_delay", "sensor_lag", "sensor_scale"}, at.name())) return false;
  if (at.name() == "encoder_eccentricity") return at.is_hinge();
  return at.rig.driving != Driving::none || at.is_one_of({"sensor_scale", "sensor_offset"}, at.name());
}

bool imposed_makes_sense(const AskedPlace& at) {
  if (at.kind.law.place == Place::sensor)
    return at.element == 1 && at.is_one_of({"sensor_offset", "sensor_delay"}, at.name());
  return at.kind.law.place == Place::joint && at.name() != "hard_stop" && at.effect() != "load_friction";
}

/// What comes back to where it was shows springs and stops; what rolls on or falls does not.
bool motion_makes_sense(const AskedPlace& at) {
  const std::string& family = at.rig.family;
  if (family == "falling_body" && at.kind.law.place == Place::joint) return at.name() == "drag_between_powers";
  const bool rolls_on = family == "wheel_running_down" || family == "falling_body";
  const bool turns_on = (family == "velocity_axis" || family == "voltage_motor") && at.turns_about_com();
  const bool inert = at.effect() == "armature";
  if (inert && at.rig.driving == Driving::none) return !rolls_on;
  const bool returns =
      at.is_one_of({"joint_spring", "cubic_stiffness", "hard_stop", "position_friction", "hysteresis", "sensor_offset"},
                   at.effect());
  return !returns || !(rolls_on || turns_on);
}

bool makes_sense(const DirtyKind& kind, int element, const DirtyRig& rig) {
  const AskedPlace at{kind, rig, element};
  if (rig.driving == Driving::imposed) return imposed_makes_sense(at);
  const bool affordable = kind.finer == 1 || (rig.driving != Driving::none && rig.stated.joints.size() <= 2);
  return affordable && body_makes_sense(at) && sensor_makes_sense(at) && motion_makes_sense(at);
}

}  // namespace

std::vector<PlacedKind> placed_kinds(const DirtyRig& rig) {
  std::vector<PlacedKind> placed;
  for (const DirtyKind& kind : dirty_kinds())
    for (int e = 0; e < elements_of(rig.stated, kind.law.place); ++e)
      if (kind.law.applies(rig.stated, e) && makes_sense(kind, e, rig)) placed.push_back({&kind, e});
  return placed;
}

}  // namespace hidden_effects::dirty
