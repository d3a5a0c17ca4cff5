#include "dirty/dirty_kind.h"

#include <map>

namespace hidden_effects::dirty {
namespace {

using Words = std::vector<std::string>;

const Words kWithPosition = {"position", "position, periodically"};
const Words kWithVelocity = {"velocity"};
const Words kWithMemory = {"velocity", "the past of the motion", "position and velocity"};
const Words kWithWay = {"velocity, by the position", "velocity, by the position periodically", "position and velocity"};
const Words kWithLoad = {"velocity", "velocity, by the position", "velocity, by the position periodically",
                         "position and velocity", "command and velocity"};
const Words kWithCommand = {"command", "command and velocity"};
const Words kWithTime = {"time", "command and time"};
const Words kWithPastCommand = {"the past of the command"};

/// What the library has of a kind of force: all of it, for a near one would stand for the law.
const Words kFriction = {"coulomb_friction",
                         "stribeck_friction",
                         "lugre_friction",
                         "hysteresis",
                         "directional_friction",
                         "position_friction",
                         "load_friction",
                         "coupled_friction",
                         "gear_efficiency",
                         "viscous_friction",
                         "directional_viscous_friction",
                         "linear_drag",
                         "quadratic_drag",
                         "quadratic_damping",
                         "torque_speed_line",
                         "rolling_resistance"};
const Words kSprings = {"joint_spring", "cubic_stiffness",     "hard_stop", "cogging",   "hysteresis",
                        "mount_tilt",   "joint_offset_torque", "buoyancy",  "cable_pull"};
const Words kOfCommand = {"torque_gain",     "torque_saturation", "supply_sag",           "thermal_fade",
                          "command_bend",    "dead_zone",         "command_quantisation", "command_offset",
                          "gear_efficiency", "torque_speed_line", "slew_rate_limit"};
const Words kLateness = {"command_delay",   "actuator_lag",     "sensor_delay", "sensor_lag",
                         "slew_rate_limit", "joint_compliance", "clock_skew"};

const std::map<std::string, Words>& words_by_law() {
  static const std::map<std::string, Words> all = {
      {"coulomb_friction", kWithVelocity},
      {"smooth_dry_friction", kWithVelocity},
      {"viscous_friction", kWithVelocity},
      {"thinning_viscous_friction", kWithVelocity},
      {"drag_between_powers", kWithVelocity},
      {"stribeck_friction", kWithVelocity},
      {"stribeck_power_friction", kWithVelocity},
      {"directional_friction", kWithVelocity},
      {"quadratic_drag", kWithVelocity},
      {"rough_drag", kWithVelocity},
      {"linear_drag", kWithVelocity},
      {"lugre_friction", kWithMemory},
      {"hysteresis", kWithMemory},
      {"position_friction", kWithWay},
      {"way_friction", kWithWay},
      {"load_friction", kWithLoad},
      {"load_power_friction", kWithLoad},
      {"joint_spring", kWithPosition},
      {"cubic_stiffness", kWithPosition},
      {"rubber_spring", kWithPosition},
      {"spring_with_play", kWithPosition},
      {"cable_spring", kWithPosition},
      {"hard_stop", kWithPosition},
      {"cogging", kWithPosition},
      {"torque_saturation", kWithCommand},
      {"torque_gain", kWithCommand},
      {"dead_zone", kWithCommand},
      {"soft_dead_zone", kWithCommand},
      {"saturating_iron", kWithCommand},
      {"thermal_fade", kWithTime},
      {"command_delay", kWithPastCommand},
      {"jittered_delay", kWithPastCommand},
      {"actuator_lag", kWithPastCommand},
      {"twofold_lag", kWithPastCommand},
      {"second_order_lag", kWithPastCommand},
  };
  return all;
}

}  // namespace

std::vector<std::string> goes_with(const DirtyKind& kind) {
  const auto found = words_by_law().find(kind.law.name);
  return found == words_by_law().end() ? Words() : found->second;
}

std::vector<std::string> effects_like(const DirtyKind& kind) {
  const std::vector<std::string> words = goes_with(kind);
  if (words == kWithPosition) return kSprings;
  if (words == kWithCommand || words == kWithTime) return kOfCommand;
  if (words == kWithPastCommand) return kLateness;
  return words.empty() ? kind.accepted : kFriction;
}

}  // namespace hidden_effects::dirty
