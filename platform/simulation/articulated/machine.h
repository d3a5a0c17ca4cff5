#pragma once

#include <lacuna/robot_spec.h>

#include "simulation/articulated/tree.h"

#include <span>
#include <vector>

namespace lacuna::articulated {

/// A joint coordinate with its own laws.
struct CoordinateNumbers {
  std::size_t dof = 0;
  std::size_t position = 0;  ///< index in a configuration; not for ball and free joints
  bool ball = false;         ///< of a ball or a free joint: has no number in a configuration
  double force = 0.0, damping = 0.0, stiffness = 0.0, rest = 0.0, dry_friction = 0.0, armature = 0.0;
  double lower = -kInfinity, upper = kInfinity;
  bool imposed = false;  ///< its velocity is imposed
};

/// An actuator and what it drives: its joint's coordinate, or a separate rotor behind an elastic transmission.
struct ActuatorNumbers {
  ActuatorKind kind = ActuatorKind::force;  ///< with forces instead of voltages
  double push = 1.0;                        ///< force per command, of kind force
  double drag = 0.0;                        ///< of back-EMF; not at the limit
  double sample_time = 0.0;                 ///< s; of a servo that holds its force in between; 0: continuous
  std::size_t coordinate = 0;
  std::size_t dof = 0, position = 0;  ///< of the coordinate that it drives
  double kp = 0.0, ki = 0.0, kd = 0.0, limit = kInfinity;
  double sag = 0.0;                                                       ///< of the supply, per force at rest
  bool compliant = false;                                                 ///< it drives a rotor; then
  double rotor_inertia = 0.0, stiffness = 0.0, damping = 0.0, gap = 0.0;  ///< at the joint
};

/// Two coupled coordinates: q(leads)·ratio + offset = q(follows), by their indices.
struct CouplingNumbers {
  std::size_t dof = 0, position = 0;  ///< of what follows
  std::size_t leading_dof = 0, leading_position = 0;
  double ratio = 1.0, offset = 0.0;
};

/// A robot's numbers as the integrator uses them: the tree, then the rotors with separate velocities, counted after the
/// tree's.
class Machine {
 public:
  Machine(const RobotSpec& robot, const simulation::JointTree& joints);

  /// Updates the numbers from a robot of the same structure.
  void set(const RobotSpec& robot);

  const Tree& tree() const { return tree_; }
  const std::vector<CoordinateNumbers>& coordinates() const { return coordinates_; }
  const std::vector<ActuatorNumbers>& actuators() const { return actuators_; }
  const std::vector<CouplingNumbers>& couplings() const { return couplings_; }
  /// With rotors.
  std::size_t dofs() const { return tree_.dofs() + rotors_; }
  std::size_t positions() const { return tree_.positions() + rotors_; }
  std::size_t rotors() const { return rotors_; }
  /// The largest possible number, with a rotor for each actuator.
  std::size_t most_dofs() const { return tree_.dofs() + actuators_.size(); }
  std::size_t most_positions() const { return tree_.positions() + actuators_.size(); }
  /// Whether inertial forces depend on the velocities.
  bool has_coriolis_forces() const { return has_coriolis_forces_; }
  bool has_balls() const { return has_balls_; }
  /// Whether any actuator's supply sags.
  bool sags() const { return sags_; }

 private:
  Tree tree_;
  std::vector<std::size_t> first_coordinate_;  ///< per joint
  std::vector<CoordinateNumbers> coordinates_;
  std::vector<ActuatorNumbers> actuators_;
  std::vector<CouplingNumbers> couplings_;
  std::size_t rotors_ = 0;
  bool has_coriolis_forces_ = false, has_balls_ = false, sags_ = false;
};

}  // namespace lacuna::articulated
