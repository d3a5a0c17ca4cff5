#pragma once

#include "plant/coordinates.h"

#include <limits>
#include <string>
#include <vector>

namespace hidden_effects {

/// A rigid body; it hangs on the joint of the same index.
struct PlantBody {
  std::string name;
  double mass = 1.0;              ///< kg
  InPlane com = InPlane::Zero();  ///< m, in the body frame, whose origin is the joint
  double inertia = 0.0;           ///< kg·m², about the centre of mass and y
};

/// A joint between the body before (the world for the first) and the body of the same index.
struct PlantJoint {
  std::string name;
  bool slides = false;               ///< along `axis`; else a hinge about y
  InPlane axis = InPlane::UnitX();   ///< of a slider, in the parent's frame
  InPlane anchor = InPlane::Zero();  ///< m, in the parent's frame
  double damping = 0.0;              ///< N·m·s/rad or N·s/m
  double stiffness = 0.0;            ///< N·m/rad or N/m, to `rest`
  double rest = 0.0;                 ///< rad or m
  double armature = 0.0;             ///< kg·m² or kg
  double force = 0.0;                ///< N·m or N, constant
};

/// What drives a joint. A rotor that is not elastic moves with its joint.
struct PlantDrive {
  std::string name;
  int joint = 0;
  bool servo = false;                                      ///< the command is a position; else a force
  double kp = 0.0, kd = 0.0;                               ///< of a servo
  double gain = 1.0;                                       ///< of the force; of a servo it multiplies kp and kd
  double offset = 0.0;                                     ///< added to the command
  double delay = 0.0;                                      ///< s, of the command
  double limit = std::numeric_limits<double>::infinity();  ///< of the force
  double rotor_inertia = 0.0;                              ///< kg·m² or kg, seen at the joint
  bool elastic = false;                                    ///< a spring lies between rotor and joint
  double stiffness = 0.0;                                  ///< N·m/rad or N/m
  double damping = 0.0;                                    ///< N·m·s/rad or N·s/m
  double gap = 0.0;                                        ///< rad or m, whole width of the play
  double torque_constant = 0.0;                            ///< N·m/A or N/A, at the joint; of a voltage
  double resistance = 0.0;                                 ///< Ohm; above 0 the command is a voltage on a motor
};

/// A sensor of a joint.
struct PlantSensor {
  std::string name;
  int joint = 0;
  bool velocity = false;  ///< else position
  double scale = 1.0;     ///< multiplies what is read
};

/// A planar open chain with its drives and sensors, as data.
struct PlantSpec {
  InPlane gravity{0.0, -9.81};  ///< m/s²
  std::vector<PlantBody> bodies;
  std::vector<PlantJoint> joints;
  std::vector<PlantDrive> drives;
  double lateness = 0.0;  ///< s, of all commands, beside what each drive has
  std::vector<PlantSensor> sensors;
};

}  // namespace hidden_effects
