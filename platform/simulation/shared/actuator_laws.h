#pragma once

#include <lacuna/robot_spec.h>

namespace lacuna::simulation {

/// An actuator's memory between steps; part of the State.
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

/// The actuator's law for the coming step of length h, at the position of the coordinate that it drives. `rate`: change
/// of the command per second.
ImplicitForce actuator_law(const ActuatorSpec& actuator, double command, double rate, double position,
                           const ActuatorMemory& memory, double step);

/// The same on a supply that sags, near the velocity of the coordinate that it drives.
ImplicitForce on_sagging_supply(const ImplicitForce& law, double sag, double velocity);

/// Updates a PID's memory after the step has led to `position` with `force`. Its integral stops while the force is at
/// its limit and would go further into it. `limit`: of that force.
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
  /// Moves the rotor through the step that led to `joint_velocity`. The actuator's force becomes that of the
  /// transmission.
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
