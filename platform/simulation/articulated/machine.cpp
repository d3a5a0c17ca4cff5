#include "simulation/articulated/machine.h"

#include <cmath>

namespace lacuna::articulated {

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
      numbers.ball = link.kind == LinkKind::ball;
      numbers.position = static_cast<std::size_t>(link.position) + numbers.dof - first;
    }
  }
  for (const Link& link : tree_.links()) {
    const bool alone = link.parent < 0 && (link.kind == LinkKind::hinge || link.kind == LinkKind::slider);
    if (link.dofs > 0 && !alone) has_coriolis_forces_ = true;
    has_balls_ = has_balls_ || link.kind == LinkKind::ball;
  }
  for (std::size_t a = 0; a < actuators_.size(); ++a) {
    const int joint = simulation::index_of(robot.joints, robot.actuators[a].joint);
    actuators_[a].coordinate = first_coordinate_[static_cast<std::size_t>(joint)];
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
      const bool stops = joint.kind != JointKind::ball;
      numbers.lower = stops ? joint.lower : -kInfinity;
      numbers.upper = stops ? joint.upper : kInfinity;
    }
  }
  rotors_ = 0;
  for (std::size_t a = 0; a < actuators_.size(); ++a) {
    const ActuatorSpec& actuator = robot.actuators[a];
    const TransmissionSpec& transmission = actuator.transmission;
    ActuatorNumbers& numbers = actuators_[a];
    CoordinateNumbers& driven = coordinates_[numbers.coordinate];
    numbers.kind = actuator.kind;
    numbers.kp = actuator.kp;
    numbers.ki = actuator.ki;
    numbers.kd = actuator.kd;
    numbers.limit = actuator.force_limit;
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
    }
  }
}

}  // namespace lacuna::articulated
