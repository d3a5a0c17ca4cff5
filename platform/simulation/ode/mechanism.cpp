#include "simulation/ode/mechanism.h"

#include "foundation/text/number_text.h"
#include "simulation/ode/session.h"

#include <algorithm>
#include <cmath>

namespace lacuna::ode {
namespace {

// N or N·m; larger values overflow inside ODE and make its world unusable.
constexpr double kLargestForce = 1e15;

}  // namespace

Mechanism::Mechanism(const simulation::JointTree& tree, const EngineSettings& settings)
    : tree_(tree), h_(settings.step / settings.substeps), joint_erp_(settings.joint_erp), joints_(tree) {
  dWorldSetERP(world_.id(), joint_erp_);
  const auto coordinates = static_cast<std::size_t>(tree.coordinates);
  own_laws_.resize(coordinates);
  rows_.resize(coordinates);
  row_velocities_.assign(coordinates, 0.0);
  law_forces_.assign(coordinates, 0.0);
}

Mechanism::~Mechanism() { take_down(); }

void Mechanism::take_down() {
  ground_.destroy();
  for (CoordinateRows& rows : rows_) {
    rows.impedance.destroy();
    rows.friction.destroy();
    rows.stop.destroy();
  }
  for (MotorRow& servo : servos_) servo.destroy();
  joints_.destroy();
  bodies_.destroy();
}

void Mechanism::build(const RobotSpec& robot, const MechanismNeeds& needs, std::span<const ActuatorPlace> actuators) {
  take_down();
  robot_ = &robot;
  needs_ = needs;
  bodies_.create(world_.id(), robot);
  joints_.create(world_.id(), robot, bodies_);
  joints_.update();
  std::fill(law_forces_.begin(), law_forces_.end(), 0.0);
  create_rows(robot, actuators);
  ground_.create(world_.id(), robot, bodies_, needs.measure_contacts);
  set_gravity(robot.gravity);
  const std::size_t joints = tree_.child.size() + 3 * rows_.size() + servos_.size() + ground_.most_contacts();
  world_.reserve(robot.bodies.size(), joints, most_rows());
}

void Mechanism::create_rows(const RobotSpec& robot, std::span<const ActuatorPlace> actuators) {
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    if (robot.joints[j].kind == JointKind::free) continue;  // no law acts on its coordinates
    const auto first = static_cast<std::size_t>(tree_.first_coordinate[j]);
    const auto count = static_cast<std::size_t>(simulation::coordinate_count(robot.joints[j].kind));
    for (std::size_t i = first; i < first + count; ++i) {
      bool compliant = false;
      double reflected_inertia = 0.0;
      for (const ActuatorPlace& actuator : actuators) {
        if (actuator.coordinate != i) continue;
        compliant = compliant || actuator.compliant;
        reflected_inertia += actuator.reflected_inertia;
      }
      create_joint_rows(robot.joints[j], i, compliant, reflected_inertia);
    }
  }
  servos_.assign(actuators.size(), {});
  for (std::size_t a = 0; a < actuators.size(); ++a)
    if (actuators[a].servo) servos_[a].create(world_.id(), joints_, actuators[a].coordinate);
}

void Mechanism::create_joint_rows(const JointSpec& joint, std::size_t coordinate, bool compliant,
                                  double reflected_inertia) {
  own_laws_[coordinate] = {.force = joint.force,
                           .dry_friction = joint.dry_friction,
                           .damping = joint.damping,
                           .stiffness = joint.stiffness,
                           .rest = joint.rest};
  CoordinateRows& rows = rows_[coordinate];
  rows = {};
  rows.armature = joint.armature + reflected_inertia;
  const bool impeded = joint.damping > 0.0 || joint.stiffness > 0.0 || rows.armature > 0.0;
  const bool stopped = std::isfinite(joint.lower) || std::isfinite(joint.upper);
  if (impeded || compliant || needs_.laws_vary) rows.impedance.create(world_.id(), joints_, coordinate);
  if (joint.dry_friction > 0.0 || needs_.laws_vary) rows.friction.create(world_.id(), joints_, coordinate);
  if (rows.friction.exists() && needs_.measure_joints) rows.friction.measure();
  if (stopped && joint.kind != JointKind::ball)
    rows.stop.create(world_.id(), joints_, coordinate, joint.lower, joint.upper);
}

std::size_t Mechanism::most_rows() const {
  const std::size_t rows_of_contact = robot_->contact.rolling_lever > 0.0 ? 6 : 3;
  return 6 * tree_.child.size() + 4 * rows_.size() + servos_.size() + rows_of_contact * ground_.most_contacts();
}

void Mechanism::add_own_loads(std::span<JointLoad> loads) const {
  for (std::size_t i = 0; i < own_laws_.size(); ++i) {
    const OwnLaws& laws = own_laws_[i];
    loads[i].force += laws.force;
    loads[i].add_friction(laws.dry_friction);
    loads[i].add_damping(laws.damping, joints_.velocities()[i]);
    loads[i].add_spring(laws.stiffness, joints_.positions()[i] - laws.rest);
  }
}

void Mechanism::set_servo(std::size_t actuator, const simulation::ImplicitForce& law) {
  MotorRow& servo = servos_[actuator];
  if (law.slope <= 0.0) {
    servo.set_law(0.0, 0.0);
    return;
  }
  const double target = law.force / law.slope;
  if (!std::isfinite(target))
    throw Error("actuator \"" + robot_->actuators[actuator].name + "\": its servo's target is not finite");
  servo.set_target(target);
  servo.set_law(1.0 / law.slope, law.limit);
}

void Mechanism::set_gravity(const Eigen::Vector3d& gravity) {
  dWorldSetGravity(world_.id(), gravity.x(), gravity.y(), gravity.z());
}

void Mechanism::add_body_load(std::size_t body, const BodyLoad& load) {
  const dBodyID id = bodies_.id(static_cast<int>(body));
  dBodyAddForce(id, load.force.x(), load.force.y(), load.force.z());
  dBodyAddTorque(id, load.torque.x(), load.torque.y(), load.torque.z());
}

void Mechanism::step(std::span<const JointLoad> loads, const ContactSpec& contact) {
  set_laws(loads);
  step_world(contact);
  check_bodies();
  if (needs_.measure_joints) read_forces();
  joints_.update();
  ground_.collide(ground_.slope());
}

void Mechanism::step_world(const ContactSpec& contact) {
  if (contact.slope != ground_.slope()) ground_.collide(contact.slope);
  bodies_.hold();
  if (!solve_world(contact)) {
    bodies_.take_back();
    ground_.break_ties();
    if (!solve_world(contact)) throw Error(std::string("ODE could not solve the step: ") + complaint());
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) row_velocities_[i] = joints_.row_velocity(i);
}

bool Mechanism::solve_world(const ContactSpec& contact) {
  ground_.begin_step(world_.id(), contact, h_, joint_erp_);
  clear_complaint();
  try {
    dWorldStep(world_.id(), h_);
  } catch (...) {
    world_.mark_failed();
    throw;
  }
  ground_.end_step();
  return complaint()[0] == '\0';
}

void Mechanism::set_laws(std::span<const JointLoad> loads) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    CoordinateRows& rows = rows_[i];
    const JointLoad& load = loads[i];
    const double position = joints_.positions()[i];
    rows.force = load.force;
    if (rows.impedance.exists()) set_impedance(rows, load, joints_.velocities()[i]);
    if (rows.friction.exists()) {
      rows.friction_limit = 0.5 * (load.friction_upper - load.friction_lower);
      rows.force += 0.5 * (load.friction_upper + load.friction_lower);
      rows.friction.set_law(0.0, rows.friction_limit);
    }
    rows.stop.set_position(position);
    if (!(std::abs(rows.force) <= kLargestForce) || !std::isfinite(rows.target))
      throw Error("the force on " + simulation::name_coordinates(*robot_)[i].name + " is " + number_text(rows.force) +
                  ", beyond anything that can be simulated");
    if (rows.force != 0.0) joints_.add_force(i, rows.force);
  }
}

/// The loads' force is that at the velocity v before the step; the row adds its decrease at v' after it: λ = −b·(v' −
/// v) − k·h·v' − I·(v' − v)/h, written as (target − v')/compliance; without a spring it is zero at v' = v.
void Mechanism::set_impedance(CoordinateRows& rows, const JointLoad& load, double velocity) const {
  const double inert = load.damping + rows.armature / h_;
  rows.resistance = inert + h_ * load.stiffness;
  if (rows.resistance <= 0.0) {
    rows.target = 0.0;
    rows.impedance.set_law(0.0, 0.0);
    return;
  }
  rows.target = inert * velocity / rows.resistance;
  rows.impedance.set_target(rows.target);
  rows.impedance.set_law(1.0 / rows.resistance, dInfinity);
}

void Mechanism::check_bodies() const {
  const int body = bodies_.exploded();
  if (body < 0) return;
  throw Error("body \"" + robot_->bodies[static_cast<std::size_t>(body)].name + "\" " + bodies_.describe(body) +
              "; the motion exploded: reduce engine.step, gains or stiffnesses");
}

void Mechanism::read_forces() {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const CoordinateRows& rows = rows_[i];
    law_forces_[i] = rows.force;
    if (rows.impedance.exists()) law_forces_[i] += rows.resistance * (rows.target - row_velocities_[i]);
    if (rows.friction.exists() && rows.friction_limit > 0.0)
      law_forces_[i] += rows.friction.measured_force(joints_.axis(i));
  }
}

}  // namespace lacuna::ode
