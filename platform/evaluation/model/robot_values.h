#pragma once

#include "evaluation/model/complaints.h"
#include "evaluation/model/model_definition.h"
#include "foundation/address.h"

#include <vector>

namespace lacuna {

/// Sets one value; a mass scales the inertia where `inertia_scales_with_mass` says so. `target` is of `robot`.
void assign_value(RobotSpec& robot, const AddressedValue& target, double value);

/// Gives the robot the values of `[model.set]` (or `[target.set]`). Where several patterns match an address, the one
/// with the fewest stars counts. A mass scales the inertia where `inertia_scales_with_mass` says so; moments of inertia
/// that are also set count after it.
void set_robot_values(RobotSpec& robot, const SystemSource& source, Complaints& complaints);

/// The values that `[model.free]` frees, or `[target.hidden]` hides, in the order of `addressed_values`, one per
/// matched address, with the same rule for several patterns. Without a `start` the robot's value is the start. A start
/// from a file must lie within the bounds, up to rounding; otherwise it is moved to the nearest bound
/// (`FreeValue::own`). Hidden values need no start.
std::vector<FreeValue> free_robot_values(RobotSpec& robot, const SystemSource& source, Complaints& complaints);

/// Gives the sensors that match the patterns (`sensor.angle*`) white noise of that standard deviation, in the unit of
/// their channels. Where several patterns match, the one with the fewest stars counts.
void set_sensor_noise(RobotSpec& robot, const std::map<std::string, double>& noise, Complaints& complaints);

}  // namespace lacuna
