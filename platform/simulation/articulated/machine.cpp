#include "simulation/articulated/machine.h"

#include <algorithm>
#include <cmath>

namespace lacuna::articulated {
namespace {

/// A motor on a voltage is a source of force and a damper.
void set_law(const ActuatorSpec& actuator, ActuatorNumbers& numbers) {
  numbers.kind = actuator.kind;
  numbers.kp = actuator.kp;
  numbers.ki = actuator.ki;
  numbers.kd = actuator.kd;
  numbers.limit = actuator.force_limit;
  numbers.sag = actuator.supply_sag;
  numbers.push = 1.0;
  numbers.drag = 0.0;
  numbers.sample_time = 0.0;
  const bool is_servo = actuator.kind == ActuatorKind::voltage_servo;
  if (!is_servo && actuator.kind != ActuatorKind::voltage) return;
  const MotorSpec& motor = actuator.motor;
  const double force_per_volt = motor.torque_constant / motor.resistance;
  const double force_per_count = motor.gain_unit * motor.supply * force_per_volt;
  numbers.kind = is_servo ? ActuatorKind::position_servo : ActuatorKind::force;
  numbers.push = force_per_volt;
  numbers.kp = is_servo ? actuator.kp * force_per_count : 0.0;
  numbers.kd = is_servo ? actuator.kd * force_per_count : 0.0;
  numbers.limit = std::min(actuator.force_limit, motor.duty_limit * motor.supply * force_per_volt);
  numbers.drag = motor.back_emf * motor.torque_constant * force_per_volt;
  numbers.sample_time = is_servo ? motor.sample_time : 0.0;
}

}  // namespace

Machine::Machine(const RobotSpec& robot, const simulation::JointTree& joints)
    : tree_(robot, joints),
      coordinates_(static_cast<std::size_t>(joints.coordinates)),
      actuators_(robot.actuators.size()) {
  for (const int first : joints.first_coordinate) first_coordinate_.push_back(static_cast<std::size_t>(first));
  for (std::size_t c = 0; c < coordinates_.size(); ++c) {
    CoordinateNumbers& numbers = coordinates_[c];
    numbers.dof = tree_.dof_of_coordinate()[c];
    for (const Link& link : tree_.links()) {
      const auto first = static_cast<std::size_t>(link.dof);
      if (numbers.dof < first || numbers.dof >= first + static_cast<std::size_t>(link.dofs)) continue;
      numbers.ball = link.kind == LinkKind::ball || link.kind == LinkKind::floating;
      numbers.position = static_cast<std::size_t>(link.position) + numbers.dof - first;
    }
  }
  for (const Link& link : tree_.links()) {
    const bool alone = link.parent < 0 && (link.kind == LinkKind::hinge || link.kind == LinkKind::slider);
    if (link.dofs > 0 && !alone) has_coriolis_forces_ = true;
  }
  for (const CoordinateNumbers& numbers : coordinates_) has_balls_ = has_balls_ || numbers.ball;
  for (std::size_t a = 0; a < actuators_.size(); ++a) {
    const int joint = simulation::index_of(robot.joints, robot.actuators[a].joint);
    actuators_[a].coordinate = first_coordinate_[static_cast<std::size_t>(joint)];
  }
  for (const CouplingSpec& coupling : robot.couplings) {
    const auto place = [&](const std::string& joint) -> const CoordinateNumbers& {
      return coordinates_[first_coordinate_[static_cast<std::size_t>(simulation::index_of(robot.joints, joint))]];
    };
    const CoordinateNumbers &own = place(coupling.joint), &leading = place(coupling.follows);
    couplings_.push_back({own.dof, own.position, leading.dof, leading.position});
  }
  set(robot);
}

void Machine::set(const RobotSpec& robot) {
  tree_.set(robot);
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const JointSpec& joint = robot.joints[j];
    const auto count = static_cast<std::size_t>(simulation::coordinate_count(joint.kind));
    for (std::size_t c = first_coordinate_[j]; c < first_coordinate_[j] + count; ++c) {
      CoordinateNumbers& numbers = coordinates_[c];
      numbers.force = joint.force;
      numbers.damping = joint.damping;
      numbers.stiffness = joint.stiffness;
      numbers.rest = joint.rest;
      numbers.dry_friction = joint.dry_friction;
      numbers.armature = joint.armature;
      numbers.imposed = false;
      const bool stops = joint.kind != JointKind::ball && joint.kind != JointKind::free;
      numbers.lower = stops ? joint.lower : -kInfinity;
      numbers.upper = stops ? joint.upper : kInfinity;
    }
  }
  for (std::size_t c = 0; c < couplings_.size(); ++c) {
    couplings_[c].ratio = robot.couplings[c].ratio;
    couplings_[c].offset = robot.couplings[c].offset;
  }
  rotors_ = 0;
  sags_ = false;
  for (std::size_t a = 0; a < actuators_.size(); ++a) {
    const ActuatorSpec& actuator = robot.actuators[a];
    const TransmissionSpec& transmission = actuator.transmission;
    ActuatorNumbers& numbers = actuators_[a];
    CoordinateNumbers& driven = coordinates_[numbers.coordinate];
    set_law(actuator, numbers);
    sags_ = sags_ || numbers.sag > 0.0;
    numbers.rotor_inertia = transmission.rotor_inertia * transmission.ratio * transmission.ratio;
    numbers.compliant = std::isfinite(transmission.stiffness);
    numbers.stiffness = transmission.stiffness;
    numbers.damping = transmission.damping;
    numbers.gap = transmission.gap;
    numbers.dof = driven.dof;
    numbers.position = driven.position;
    if (numbers.compliant) {
      numbers.dof = tree_.dofs() + rotors_;
      numbers.position = tree_.positions() + rotors_;
      ++rotors_;
    } else {
      driven.armature += numbers.rotor_inertia;
      driven.imposed = actuator.kind == ActuatorKind::motion;
    }
  }
}

}  // namespace lacuna::articulated
