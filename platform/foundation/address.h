#pragma once

#include <lacuna/physical_effect.h>
#include <lacuna/robot_spec.h>
#include <lacuna/time_series.h>

#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

/// A number in a robot spec that has an address, such as `body.torso.mass`,
/// `joint.slider.damping`, `actuator.motor.gain`, `sensor.t1.delay`, `contact.friction`, `world.gravity.z`.
struct AddressedValue {
  std::string address;
  std::string unit;  ///< SI; for a joint's value it depends on the joint's kind
  double* value;     ///< into the given spec
  double lower;      ///< physical bounds, inclusive
  double upper;
  bool may_be_infinite = false;  ///< "no limit", or rigid
};

/// Every addressed value of a spec, in a fixed order that depends only on its structure.
std::vector<AddressedValue> addressed_values(RobotSpec& robot);

/// Whether all of them are within their bounds and finite, except where they may be infinite. Builds no list.
bool values_in_bounds(const RobotSpec& robot);

/// Whether `address` matches `pattern`, in which `*` stands for any run of characters except dots.
bool matches(std::string_view pattern, std::string_view address);

/// For a parameter of a placed effect: `effect.ID.PARAMETER`.
std::string effect_address(std::string_view id, std::string_view parameter);
/// Whether an address belongs to a placed effect, not to the robot; whether it belongs to placement `id`.
bool is_of_effect(std::string_view address);
bool is_of_effect(std::string_view address, std::string_view id);

/// The address of a value of a single setup: `body.load.mass@heavy`.
std::string address_in_setup(std::string_view address, std::string_view setup);
/// `body.load.mass` for it, and the address itself if it belongs to no setup.
std::string_view without_setup(std::string_view address);

/// Coordinates of a joint: hinge and slider 1, universal 2, ball 3, free 6, fixed 0.
int coordinate_count(JointKind kind);

/// Channels of a sensor, and of all sensors in spec order: names and SI units.
std::vector<Channel> sensor_channels(const RobotSpec& robot, const SensorSpec& sensor);
std::vector<Channel> sensor_channels(const RobotSpec& robot);
/// One channel per actuator: its name and its command's SI unit, "1" for a relative one.
Channel command_channel(const RobotSpec& robot, const ActuatorSpec& actuator);
std::vector<Channel> command_channels(const RobotSpec& robot);

/// Elements such as `joint.hinge` that match the patterns, in spec order without repeats.
struct ElementMatch {
  ElementKind kind = ElementKind::world;
  std::vector<int> elements;  ///< indices into the spec's list of that kind
};
/// Throws `Error` when a pattern matches nothing (with the nearest name) or the patterns mix kinds.
/// No patterns, or "world": the world.
ElementMatch match_elements(const RobotSpec& robot, const std::vector<std::string>& patterns);

/// "joint", "body", "actuator", "sensor", "world".
std::string_view to_string(ElementKind kind);

}  // namespace lacuna
