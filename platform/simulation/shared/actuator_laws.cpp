#include "simulation/shared/actuator_laws.h"

#include <algorithm>
#include <cmath>

namespace lacuna::simulation {
namespace {

/// The part of the twist that loads the spring.
double beyond_gap(double twist, double gap) {
  const double half = 0.5 * gap;
  if (twist > half) return twist - half;
  if (twist < -half) return twist + half;
  return 0.0;
}

ImplicitForce pid_law(const ActuatorSpec& actuator, double command, double rate, double position,
                      const ActuatorMemory& memory, double step) {
  const double error = command - position;
  return {.force = actuator.kp * error + actuator.ki * (memory.integral + step * error) + actuator.kd * rate,
          .slope = actuator.kp * step + actuator.ki * step * step + actuator.kd,
          .limit = actuator.force_limit};
}

}  // namespace

double ImplicitForce::at(double velocity) const { return std::clamp(force - slope * velocity, -limit, limit); }

ImplicitForce actuator_law(const ActuatorSpec& actuator, double command, double rate, double position,
                           const ActuatorMemory& memory, double step) {
  switch (actuator.kind) {
    case ActuatorKind::force:
      return {.force = std::clamp(command, -actuator.force_limit, actuator.force_limit),
              .slope = 0.0,
              .limit = actuator.force_limit};
    case ActuatorKind::velocity_servo:
      return {.force = actuator.kd * command, .slope = actuator.kd, .limit = actuator.force_limit};
    case ActuatorKind::position_servo:
      return {.force = actuator.kp * (command - position),
              .slope = actuator.kd + step * actuator.kp,
              .limit = actuator.force_limit};
    case ActuatorKind::pid: return pid_law(actuator, command, rate, position, memory, step);
    case ActuatorKind::voltage:
    case ActuatorKind::voltage_servo:
    case ActuatorKind::motion: break;  // refused by ode_engine.cpp
  }
  return {};
}

ImplicitForce on_sagging_supply(const ImplicitForce& law, double sag, double velocity) {
  const double share = 1.0 / (1.0 + sag * std::abs(law.at(velocity)));
  return {.force = share * law.force, .slope = share * law.slope, .limit = share * law.limit};
}

void remember_pid(double limit, double command, double position, double force, double step, ActuatorMemory& memory) {
  const double error = command - position;
  const bool saturated = std::abs(force) >= limit && force * error > 0.0;
  if (!saturated) memory.integral += step * error;
}

CompliantTransmission::CompliantTransmission(const TransmissionSpec& spec, const ActuatorMemory& rotor,
                                             const ImplicitForce& motor, double joint_position, double joint_velocity,
                                             double step)
    : step_(step) {
  const double twist = rotor.rotor_position - joint_position;
  const double stretch = beyond_gap(twist, spec.gap);
  const bool engaged = spec.gap == 0.0 || stretch != 0.0;
  const double rotor_inertia = spec.rotor_inertia * spec.ratio * spec.ratio / step;
  spring_force_ = spec.stiffness * stretch;
  coupling_ = engaged ? step * spec.stiffness + spec.damping : 0.0;

  // A motor at its limit exerts that limit at any velocity.
  const double foreseen = motor.at(rotor.rotor_velocity);
  const bool limited = std::abs(foreseen) >= motor.limit;
  inertia_ = rotor_inertia + coupling_ + (limited ? 0.0 : motor.slope);
  drive_ = (limited ? foreseen : motor.force) + rotor_inertia * rotor.rotor_velocity;
  if (inertia_ <= 0.0) {  // a rotor without inertia, free in its gap, moves with the joint
    inertia_ = 1.0;
    drive_ = joint_velocity;
  }
  const double share = coupling_ / inertia_;
  joint_force_ = spring_force_ * (1.0 - share) + share * drive_;
  joint_damping_ = coupling_ - coupling_ * share;
}

void CompliantTransmission::advance(double joint_velocity, ActuatorMemory& rotor) const {
  rotor.rotor_velocity = (drive_ - spring_force_ + coupling_ * joint_velocity) / inertia_;
  rotor.rotor_position += step_ * rotor.rotor_velocity;
  rotor.force = joint_force_ - joint_damping_ * joint_velocity;
}

}  // namespace lacuna::simulation
