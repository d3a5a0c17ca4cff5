#pragma once

#include "plant/plant_spec.h"

#include <string>

namespace hidden_effects::dirty {

/// What a number of the robot file is: it decides which effects of the library stand in for an error of it.
enum class Quantity {
  mass,             ///< kg, of a body
  lever,            ///< m, the z of a body's centre of mass
  inertia,          ///< kg·m², of a body about y
  armature,         ///< kg·m² or kg, of a joint
  damping,          ///< N·m·s/rad or N·s/m, of a joint
  stiffness,        ///< N·m/rad or N/m, of a joint
  rest,             ///< rad or m, where a joint's spring is at rest
  gain,             ///< of a drive
  kp,               ///< N·m/rad or N/m, of a servo
  kd,               ///< N·m·s/rad or N·s/m, of a servo
  torque_constant,  ///< N·m/A or N/A, of a drive by voltage
  scale             ///< of a sensor
};

/// A number of the robot file at a body, joint, drive or sensor.
struct RobotValue {
  Quantity quantity = Quantity::mass;
  int element = 0;

  double& in(PlantSpec& spec) const;
  double in(const PlantSpec& spec) const;
  std::string address(const PlantSpec& spec) const;  ///< "body.arm.mass"
  int joint(const PlantSpec& spec) const;            ///< that it belongs to
  bool operator==(const RobotValue&) const = default;
};

}  // namespace hidden_effects::dirty
