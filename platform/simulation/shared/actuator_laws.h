#pragma once

#include <lacuna/robot_spec.h>

namespace lacuna::simulation {

/// What an actuator remembers from step to step; part of the State.
struct ActuatorMemory {
  double force = 0.0;           ///< exerted in the last step, joint side
  double integral = 0.0;        ///< of a PID's error, rad·s or m·s
  double rotor_position = 0.0;  ///< joint side, rad or m; of a compliant transmission
  double rotor_velocity = 0.0;
};

/// A force that is linear in the velocity at the end of the step and limited:
/// clamp(force − slope·v, ±limit).
struct ImplicitForce {
  double force = 0.0;
  double slope = 0.0;
  double limit = kInfinity;
  double at(double velocity) const;
};

/// The actuator's law for the coming step of length h, at the position of what it drives. `rate`: by how much the
/// command changes in a second.
ImplicitForce actuator_law(const ActuatorSpec& actuator, double command, double rate, double position,
                           const ActuatorMemory& memory, double step);

/// The same on a supply that sags, for about the velocity of what the actuator drives.
ImplicitForce on_sagging_supply(const ImplicitForce& law, double sag, double velocity);

/// Puts down what a PID remembers, once the step has led to `position` with `force`. Its integral
/// stands still while the force is at its limit and would be driven further into it.
/// `limit`: of that force.
void remember_pid(double limit, double command, double position, double force, double step, ActuatorMemory& memory);

/// A compliant transmission between an actuator and its joint for one step (M. W. Spong, J. Dyn.
/// Syst. Meas. Control 109 (1987) 310; backlash as a dead zone of the spring, M. Nordin and
/// P.-O. Gutman, Automatica 38 (2002) 1633). The rotor's equation is integrated linearly
/// implicitly and eliminated, so that the joint sees a constant force and a damping.
class CompliantTransmission {
 public:
  CompliantTransmission(const TransmissionSpec& spec, const ActuatorMemory& rotor, const ImplicitForce& motor,
                        double joint_position, double joint_velocity, double step);
  double joint_force() const { return joint_force_; }
  double joint_damping() const { return joint_damping_; }
  /// Moves the rotor through the step that led to `joint_velocity`. The force in the transmission
  /// becomes the actuator's.
  void advance(double joint_velocity, ActuatorMemory& rotor) const;

 private:
  double step_;
  double spring_force_;  // at the start of the step, on the joint
  double coupling_;      // K = h·k + c
  double inertia_;       // D = J/h + K + motor slope
  double drive_;         // motor force + J·ω/h
  double joint_force_;
  double joint_damping_;
};

}  // namespace lacuna::simulation
