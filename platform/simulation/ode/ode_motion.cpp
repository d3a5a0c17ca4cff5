#include "simulation/ode/ode_motion.h"

#include "simulation/ode/session.h"

#include <algorithm>
#include <cmath>

namespace lacuna::ode {
namespace {

constexpr std::size_t kDoublesPerActuator = 4;

MechanismNeeds needs_of(const simulation::EngineModel& model) {
  MechanismNeeds needs{.laws_vary = model.effects().acts_in_steps()};
  for (const SensorSpec& sensor : model.structure().robot.sensors) {
    needs.measure_joints = needs.measure_joints || sensor.kind == SensorKind::joint_force;
    needs.measure_contacts = needs.measure_contacts || sensor.kind == SensorKind::contact_force;
  }
  return needs;
}

}  // namespace

OdeMotion::OdeMotion(const simulation::EngineModel& model)
    : tree_(model.tree()), settings_(model.settings()), h_(model.step()), needs_(needs_of(model)) {
  const RobotSpec& robot = model.structure().robot;
  const std::size_t actuators = robot.actuators.size(), bodies = robot.bodies.size();
  const auto coordinates = static_cast<std::size_t>(tree_.coordinates);
  places_.resize(actuators);
  memories_.resize(actuators);
  laws_.resize(actuators);
  transmissions_.resize(actuators);
  actuator_forces_.resize(actuators);
  joint_forces_.resize(coordinates);
  loads_.resize(coordinates);
  asked_positions_.resize(coordinates);
  body_loads_.resize(bodies);
  start_motions_.resize(bodies);
  body_positions_.resize(bodies);
  body_velocities_.resize(bodies);
  body_angular_velocities_.resize(bodies);
  body_orientations_.resize(bodies, Eigen::Quaterniond::Identity());
  elements_ = simulation::element_coordinates(robot, tree_);
}

void OdeMotion::build(const RobotSpec& robot) {
  join_session();
  robot_ = &robot;
  contact_ = robot.contact;
  place_actuators();
  if (!mechanism_) mechanism_ = std::make_unique<Mechanism>(tree_, settings_);
  mechanism_->build(robot, needs_, places_);
  lay_out_view();
}

void OdeMotion::place_actuators() {
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const ActuatorSpec& actuator = robot_->actuators[i];
    const TransmissionSpec& transmission = actuator.transmission;
    const bool compliant = std::isfinite(transmission.stiffness);
    places_[i] = {
        .coordinate = static_cast<std::size_t>(elements_.actuators[i]),
        .servo = !compliant && actuator.kind != ActuatorKind::force,
        .compliant = compliant,
        .reflected_inertia = compliant ? 0.0 : transmission.rotor_inertia * transmission.ratio * transmission.ratio};
  }
}

void OdeMotion::lay_out_view() {
  view_ = {.time = 0.0,
           .positions = mechanism_->joints().positions(),
           .velocities = mechanism_->joints().velocities(),
           .actuator_forces = actuator_forces_,
           .first_coordinate = elements_.joints,
           .actuator_coordinate = elements_.actuators,
           .sensor_coordinate = elements_.sensors,
           .body_positions = body_positions_,
           .body_velocities = body_velocities_,
           .body_orientations = body_orientations_,
           .body_angular_velocities = body_angular_velocities_};
}

void OdeMotion::begin(const StartState& start) {
  simulation::place_bodies(*robot_, tree_, start, start_motions_);
  mechanism_->bodies().place(start_motions_);
  std::fill(joint_forces_.begin(), joint_forces_.end(), 0.0);
  if (start.positions.empty())
    mechanism_->joints().set_positions(joint_forces_);  // zeros
  else
    mechanism_->joints().set_positions(start.positions);
  mechanism_->joints().update();
  mechanism_->check_bodies();
  mechanism_->ground().collide(contact_.slope);
  for (std::size_t a = 0; a < memories_.size(); ++a)
    memories_[a] = {.rotor_position = mechanism_->joints().positions()[places_[a].coordinate],
                    .rotor_velocity = mechanism_->joints().velocities()[places_[a].coordinate]};
}

const StepView& OdeMotion::look(double time, bool at_bodies) {
  for (std::size_t i = 0; i < memories_.size(); ++i) actuator_forces_[i] = memories_[i].force;
  if (at_bodies)
    mechanism_->bodies().read(body_positions_, body_velocities_, body_orientations_, body_angular_velocities_);
  view_.time = time;
  return view_;
}

void OdeMotion::advance(const simulation::StepOrder& order) {
  set_laws(order);
  std::fill(loads_.begin(), loads_.end(), JointLoad{});
  mechanism_->add_own_loads(loads_);
  if (order.loads != nullptr) ask(*order.loads);
  for (std::size_t a = 0; a < laws_.size(); ++a) apply_actuator(a);
  if (order.loads != nullptr) remember_asked();
  mechanism_->step(loads_, contact_);
  settle_actuators(order);
  sum_joint_forces();
  if (order.loads != nullptr) order.loads->advance(asked_, h_);
}

double OdeMotion::position_of(std::size_t a) const {
  return places_[a].compliant ? memories_[a].rotor_position : mechanism_->joints().positions()[places_[a].coordinate];
}

void OdeMotion::set_laws(const simulation::StepOrder& order) {
  for (std::size_t a = 0; a < laws_.size(); ++a) {
    const ActuatorSpec& actuator = robot_->actuators[a];
    if (std::isnan(order.commands[a])) {  // off
      laws_[a] = {};
      actuator_forces_[a] = memories_[a].force = 0.0;
      continue;
    }
    laws_[a] = simulation::actuator_law(actuator, order.commands[a], order.rates[a], position_of(a), memories_[a], h_);
    if (actuator.supply_sag > 0.0) {
      const double velocity =
          places_[a].compliant ? memories_[a].rotor_velocity : mechanism_->joints().velocities()[places_[a].coordinate];
      laws_[a] = simulation::on_sagging_supply(laws_[a], actuator.supply_sag, velocity);
    }
    if (!places_[a].compliant && actuator.kind == ActuatorKind::force)
      actuator_forces_[a] = memories_[a].force = laws_[a].force;
  }
}

void OdeMotion::ask(simulation::LoadSource& source) {
  std::fill(body_loads_.begin(), body_loads_.end(), BodyLoad{});
  contact_ = robot_->contact;
  Eigen::Vector3d gravity = robot_->gravity;
  StepLoads loads{.joints = loads_, .bodies = body_loads_, .contact = contact_, .gravity = gravity};
  source.add_loads(view_, h_, loads);
  mechanism_->set_gravity(gravity);
  for (std::size_t i = 0; i < body_loads_.size(); ++i) mechanism_->add_body_load(i, body_loads_[i]);
}

void OdeMotion::remember_asked() {
  std::copy(view_.positions.begin(), view_.positions.end(), asked_positions_.begin());
  asked_ = view_;
  asked_.positions = asked_positions_;
}

void OdeMotion::apply_actuator(std::size_t a) {
  const ActuatorPlace& place = places_[a];
  JointLoad& load = loads_[place.coordinate];
  if (place.servo) {
    mechanism_->set_servo(a, laws_[a]);
  } else if (!place.compliant) {
    load.force += memories_[a].force;
  } else {
    const Joints& joints = mechanism_->joints();
    const double velocity = joints.velocities()[place.coordinate];
    transmissions_[a].emplace(robot_->actuators[a].transmission, memories_[a], laws_[a],
                              joints.positions()[place.coordinate], velocity, h_);
    load.force += transmissions_[a]->joint_force();
    load.add_damping(transmissions_[a]->joint_damping(), velocity);
  }
}

void OdeMotion::settle_actuators(const simulation::StepOrder& order) {
  for (std::size_t a = 0; a < memories_.size(); ++a) {
    const ActuatorPlace& place = places_[a];
    const ActuatorSpec& actuator = robot_->actuators[a];
    simulation::ActuatorMemory& memory = memories_[a];
    const double velocity = mechanism_->row_velocity(place.coordinate);
    double motor_force = 0.0;
    if (place.servo) motor_force = memory.force = laws_[a].at(velocity);
    if (place.compliant) {
      transmissions_[a]->advance(velocity, memory);
      motor_force = laws_[a].at(memory.rotor_velocity);
    }
    if (actuator.kind != ActuatorKind::pid || std::isnan(order.commands[a])) continue;
    simulation::remember_pid(laws_[a].limit, order.commands[a], position_of(a), motor_force, h_, memory);
  }
}

simulation::SensedForces OdeMotion::sensed_forces() const {
  const Ground& ground = mechanism_->ground();
  return {.joint_forces = joint_forces_, .contact_forces = ground.contact_forces(), .touching = ground.touching()};
}

void OdeMotion::sum_joint_forces() {
  if (!needs_.measure_joints) return;
  for (std::size_t i = 0; i < joint_forces_.size(); ++i) joint_forces_[i] = mechanism_->law_force(i);
  for (std::size_t a = 0; a < places_.size(); ++a)
    if (places_[a].servo) joint_forces_[places_[a].coordinate] += memories_[a].force;
}

std::vector<std::pair<std::string, std::size_t>> OdeMotion::sections() const {
  return {{"positions", joint_forces_.size()},
          {"velocities", joint_forces_.size()},
          {"bodies", kDoublesPerBody * body_loads_.size()},
          {"actuators", kDoublesPerActuator * memories_.size()}};
}

void OdeMotion::save(simulation::StateWriter& writer) const {
  writer.put(mechanism_->joints().positions());
  writer.put(mechanism_->joints().velocities());
  mechanism_->bodies().save(writer);
  for (const simulation::ActuatorMemory& m : memories_)
    for (const double value : {m.force, m.integral, m.rotor_position, m.rotor_velocity}) writer.put(value);
}

void OdeMotion::load(simulation::StateReader& reader) {
  std::vector<double> coordinates(joint_forces_.size());
  reader.get(coordinates);
  mechanism_->joints().set_positions(coordinates);
  reader.get(coordinates);  // velocities follow from the bodies
  mechanism_->bodies().load(reader);
  mechanism_->joints().update();
  for (simulation::ActuatorMemory& m : memories_)
    for (double* value : {&m.force, &m.integral, &m.rotor_position, &m.rotor_velocity}) *value = reader.get();
  mechanism_->check_bodies();
  mechanism_->ground().collide(contact_.slope);
}

}  // namespace lacuna::ode
