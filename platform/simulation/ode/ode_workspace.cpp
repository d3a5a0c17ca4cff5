#include "simulation/ode/ode_workspace.h"

#include "simulation/shared/robot_checks.h"

#include <lacuna/error.h>

#include <algorithm>
#include <cmath>

namespace lacuna::ode {
namespace {

constexpr std::size_t kDoublesPerActuator = 5;

MechanismNeeds needs_of(const OdeModel& model) {
  MechanismNeeds needs{.laws_vary = !model.effects().before_step().empty()};
  for (const SensorSpec& sensor : model.structure().robot.sensors) {
    needs.measure_joints = needs.measure_joints || sensor.kind == SensorKind::joint_force;
    needs.measure_contacts = needs.measure_contacts || sensor.kind == SensorKind::contact_force;
  }
  return needs;
}

}  // namespace

OdeWorkspace::OdeWorkspace(const OdeModel& model)
    : instance(model.structure(), model.slots()),
      effects(model.effects(), instance),
      sensors(model.structure().robot, model.longest_sensor_delays()),
      drive(model.longest_command_delays(), model.settings()),
      model_(model),
      needs_(needs_of(model)) {
  const RobotSpec& robot = model.structure().robot;
  const std::size_t actuators = robot.actuators.size(), bodies = robot.bodies.size();
  const auto coordinates = static_cast<std::size_t>(model.tree().coordinates);
  places.resize(actuators);
  memories.resize(actuators);
  commands.resize(actuators);
  laws.resize(actuators);
  transmissions.resize(actuators);
  actuator_forces.resize(actuators);
  joint_forces.resize(coordinates);
  loads.resize(coordinates);
  body_loads.resize(bodies);
  start_motions.resize(bodies);
  readings_before.resize(model.channels().size());
  output_row.resize(model.channels().size());
  body_positions_.resize(bodies);
  body_velocities_.resize(bodies);
  body_angular_velocities_.resize(bodies);
  body_orientations_.resize(bodies, Eigen::Quaterniond::Identity());
  for (const ActuatorSpec& actuator : robot.actuators) {
    const auto joint = static_cast<std::size_t>(simulation::index_of(robot.joints, actuator.joint));
    actuator_coordinates_.push_back(model.tree().first_coordinate[joint]);
  }
}

void OdeWorkspace::build(std::span<const double> parameters) {
  instance.set(parameters);
  RobotSpec& robot = instance.robot();
  effects.amend(robot);
  if (const std::string complaint = simulation::unphysical(robot); !complaint.empty()) throw Error(complaint);
  sensors.configure(robot, model_.settings());
  place_actuators(robot);
  if (!mechanism) mechanism = std::make_unique<Mechanism>(model_.tree(), model_.settings());
  mechanism->build(robot, needs_, places);
  lay_out_view();
}

void OdeWorkspace::place_actuators(const RobotSpec& robot) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    const ActuatorSpec& actuator = robot.actuators[i];
    const TransmissionSpec& transmission = actuator.transmission;
    const bool compliant = std::isfinite(transmission.stiffness);
    places[i] = {
        .coordinate = static_cast<std::size_t>(actuator_coordinates_[i]),
        .servo = !compliant && actuator.kind != ActuatorKind::force,
        .compliant = compliant,
        .reflected_inertia = compliant ? 0.0 : transmission.rotor_inertia * transmission.ratio * transmission.ratio};
  }
}

void OdeWorkspace::look(double time, bool at_bodies) {
  for (std::size_t i = 0; i < memories.size(); ++i) actuator_forces[i] = memories[i].force;
  if (at_bodies)
    mechanism->bodies().read(body_positions_, body_velocities_, body_orientations_, body_angular_velocities_);
  view.time = time;
}

void OdeWorkspace::lay_out_view() {
  view = {.time = 0.0,
          .positions = mechanism->joints().positions(),
          .velocities = mechanism->joints().velocities(),
          .actuator_forces = actuator_forces,
          .first_coordinate = model_.tree().first_coordinate,
          .actuator_coordinate = actuator_coordinates_,
          .body_positions = body_positions_,
          .body_velocities = body_velocities_,
          .body_orientations = body_orientations_,
          .body_angular_velocities = body_angular_velocities_};
}

simulation::SensedForces OdeWorkspace::sensed_forces() const {
  const Ground& ground = mechanism->ground();
  return {.joint_forces = joint_forces, .contact_forces = ground.contact_forces(), .touching = ground.touching()};
}

void OdeWorkspace::sum_joint_forces() {
  if (!needs_.measure_joints) return;
  for (std::size_t i = 0; i < joint_forces.size(); ++i) joint_forces[i] = mechanism->law_force(i);
  for (std::size_t a = 0; a < places.size(); ++a)
    if (places[a].servo) joint_forces[places[a].coordinate] += memories[a].force;
}

std::vector<std::pair<std::string, std::size_t>> OdeWorkspace::sections() const {
  const std::size_t readings = sensors.readings().size();
  return {{"clock", 2},
          {"positions", joint_forces.size()},
          {"velocities", joint_forces.size()},
          {"bodies", kDoublesPerBody * body_loads.size()},
          {"actuators", kDoublesPerActuator * memories.size()},
          {"effects", model_.effects().state_size()},
          {"sensors", readings},
          {"sensor_delays", sensors.memory_size() - readings},
          {"commands", drive.lines_size()}};
}

void OdeWorkspace::save(double origin, std::uint64_t step, State& state) const {
  simulation::StateWriter writer(state.values);
  writer.put(origin);
  writer.put(static_cast<double>(step));
  writer.put(mechanism->joints().positions());
  writer.put(mechanism->joints().velocities());
  mechanism->bodies().save(writer);
  for (const simulation::ActuatorMemory& m : memories)
    for (const double value : {m.force, m.integral, m.last_command, m.rotor_position, m.rotor_velocity})
      writer.put(value);
  effects.save(writer);
  sensors.save(writer);
  drive.save_lines(writer);
  drive.save_controller(writer);
}

std::pair<double, std::uint64_t> OdeWorkspace::saved_clock(const State& state) {
  simulation::StateReader reader(state.values);
  const double origin = reader.get();
  return {origin, static_cast<std::uint64_t>(reader.get())};
}

void OdeWorkspace::load(const State& state) {
  simulation::StateReader reader(state.values);
  reader.skip(2);  // the clock
  std::vector<double> coordinates(joint_forces.size());
  reader.get(coordinates);
  mechanism->joints().set_positions(coordinates);
  reader.get(coordinates);  // velocities follow from the bodies
  mechanism->bodies().load(reader);
  mechanism->joints().update();
  for (simulation::ActuatorMemory& m : memories)
    for (double* value : {&m.force, &m.integral, &m.last_command, &m.rotor_position, &m.rotor_velocity})
      *value = reader.get();
  effects.load(reader);
  sensors.load(reader);
  drive.load_lines(reader);
  drive.load_controller(reader);
}

}  // namespace lacuna::ode
