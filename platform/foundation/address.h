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
  std::string unit;  ///< SI; depends on the joint's kind where it is a joint's
  double* value;     ///< into the spec that was asked
  double lower;      ///< physical bounds, inclusive
  double upper;
  bool may_be_infinite = false;  ///< "no limit", or rigid
};

/// Every addressed value of a spec, in a fixed order that depends on its structure alone.
std::vector<AddressedValue> addressed_values(RobotSpec& robot);

/// Whether all of them are within their bounds and, but where they may be infinite, finite. Makes no list.
bool values_in_bounds(const RobotSpec& robot);

/// Whether `address` is meant by `pattern`, in which `*` stands for any run of characters
/// other than a dot.
bool matches(std::string_view pattern, std::string_view address);

/// Of a parameter of a placed effect: `effect.ID.PARAMETER`.
std::string effect_address(std::string_view id, std::string_view parameter);
/// Whether an address is a placed effect's, not the robot's; whether it is that of placement `id`.
bool is_of_effect(std::string_view address);
bool is_of_effect(std::string_view address, std::string_view id);

/// The address of a value that belongs to one setup alone: `body.load.mass@heavy`.
std::string address_in_setup(std::string_view address, std::string_view setup);
/// `body.load.mass` of it, and of an address that belongs to no setup.
std::string_view without_setup(std::string_view address);

/// Coordinates of a joint: hinge and slider 1, universal 2, ball 3, free 6, fixed 0.
int coordinate_count(JointKind kind);

/// Channels of a sensor, and of all sensors in spec order: names and SI units.
std::vector<Channel> sensor_channels(const RobotSpec& robot, const SensorSpec& sensor);
std::vector<Channel> sensor_channels(const RobotSpec& robot);
/// One channel an actuator: its name and its command's SI unit, "1" for a relative one.
Channel command_channel(const RobotSpec& robot, const ActuatorSpec& actuator);
std::vector<Channel> command_channels(const RobotSpec& robot);

/// Elements such as `joint.hinge` that the patterns name, in spec order without repeats.
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
