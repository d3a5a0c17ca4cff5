#pragma once

#include <lacuna/engine_settings.h>
#include <lacuna/physical_effect.h>

#include "simulation/ode/bodies.h"
#include "simulation/ode/ground.h"
#include "simulation/ode/joints.h"
#include "simulation/ode/motor_row.h"
#include "simulation/ode/world.h"
#include "simulation/shared/actuator_laws.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace lacuna::ode {

/// Optional parts of a mechanism; unused ones cost nothing.
struct MechanismNeeds {
  bool laws_vary = false;         ///< effects may put any law on any coordinate in a step
  bool measure_joints = false;    ///< are joint forces read?
  bool measure_contacts = false;  ///< are contact forces read?
};

/// How an actuator acts on the mechanism in one simulation.
struct ActuatorPlace {
  std::size_t coordinate = 0;
  bool servo = false;              ///< has a separate constraint row
  bool compliant = false;          ///< acts through a spring: force and damping change each step
  double reflected_inertia = 0.0;  ///< of a rigidly coupled rotor, on the joint's side
};

/// A robot in a separate ODE world: bodies, joints, laws on the joint coordinates, servos and the ground. Belongs to
/// one workspace.
class Mechanism {
 public:
  Mechanism(const simulation::JointTree& tree, const EngineSettings& settings);
  ~Mechanism();

  /// Removes the old robot and builds this one at its zero configuration. `robot` must outlive its use; `actuators`:
  /// one each.
  void build(const RobotSpec& robot, const MechanismNeeds& needs, std::span<const ActuatorPlace> actuators);

  Bodies& bodies() { return bodies_; }
  const Bodies& bodies() const { return bodies_; }
  Joints& joints() { return joints_; }
  const Joints& joints() const { return joints_; }
  Ground& ground() { return ground_; }

  /// Forces of the robot's own laws at its current state, the starting point of each step. Per coordinate.
  void add_own_loads(std::span<JointLoad> loads) const;

  void set_servo(std::size_t actuator, const simulation::ImplicitForce& law);
  void set_gravity(const Eigen::Vector3d& gravity);
  void add_body_load(std::size_t body, const BodyLoad& load);

  /// One integration step under these laws. Throws `Error` for loads that are not finite, for
  /// failures and complaints of ODE, and where a body explodes.
  void step(std::span<const JointLoad> loads, const ContactSpec& contact);

  /// Throws `Error` that names a body whose motion is not finite or beyond sane bounds.
  void check_bodies() const;

  /// Velocity of a coordinate at the end of the last step along its axis at the step's start.
  double row_velocity(std::size_t coordinate) const { return row_velocities_[coordinate]; }
  /// Force of the laws (without servos) on a coordinate in the last step; needs `measure_joints`.
  double law_force(std::size_t coordinate) const { return law_forces_[coordinate]; }

 private:
  struct CoordinateRows {
    MotorRow impedance, friction;
    StopRow stop;
    double armature = 0.0;
    // of the coming step
    double resistance = 0.0;  // damping + h·stiffness + armature/h: reciprocal of the row's compliance
    double target = 0.0;
    double friction_limit = 0.0;
    double force = 0.0;
  };

  /// Of a joint, on each of its coordinates.
  struct OwnLaws {
    double force = 0.0, dry_friction = 0.0, damping = 0.0, stiffness = 0.0, rest = 0.0;
  };

  void create_rows(const RobotSpec& robot, std::span<const ActuatorPlace> actuators);
  void create_joint_rows(const JointSpec& joint, std::size_t coordinate, bool compliant, double reflected_inertia);
  void take_down();
  void set_laws(std::span<const JointLoad> loads);
  void set_impedance(CoordinateRows& rows, const JointLoad& load, double velocity) const;
  void step_world(const ContactSpec& contact);
  bool solve_world(const ContactSpec& contact);
  void read_forces();
  std::size_t most_rows() const;

  const simulation::JointTree& tree_;
  double h_, joint_erp_;
  World world_;
  const RobotSpec* robot_ = nullptr;
  MechanismNeeds needs_;
  Bodies bodies_;
  Joints joints_;
  Ground ground_;
  std::vector<OwnLaws> own_laws_;  // per coordinate
  std::vector<CoordinateRows> rows_;
  std::vector<MotorRow> servos_;  // per actuator
  std::vector<double> row_velocities_, law_forces_;
};

}  // namespace lacuna::ode
