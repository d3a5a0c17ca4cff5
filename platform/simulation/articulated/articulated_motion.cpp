#include "simulation/articulated/articulated_motion.h"

#include "foundation/text/number_text.h"

#include <lacuna/error.h>

#include <algorithm>
#include <cmath>

namespace lacuna::articulated {
namespace {

// Beyond these values the integration has failed.
constexpr double kFarthest = 1e6;  // rad or m
constexpr double kFastest = 1e6;   // rad/s or m/s

constexpr double kSameTime = 1e-6;  // integration steps

/// The size with a rotor for each actuator.
void put_padded(std::span<const double> numbers, std::size_t size, simulation::StateWriter& writer) {
  writer.put(numbers);
  for (std::size_t i = numbers.size(); i < size; ++i) writer.put(0.0);
}

}  // namespace

ArticulatedMotion::ArticulatedMotion(const simulation::EngineModel& model)
    : length_(model.step()),
      elements_(simulation::element_coordinates(model.structure().robot, model.tree())),
      machine_(model.structure().robot, model.tree()),
      loads_look_at_bodies_(model.effects().looks_at_bodies()),
      contact_forces_(model.structure().robot.bodies.size(), Eigen::Vector3d::Zero()),
      touching_(model.structure().robot.bodies.size(), 0) {
  make_integrator();
}

void ArticulatedMotion::make_integrator() {
  integrator_ = std::make_unique<Integrator>(machine_, elements_);
  integrator_->step().look_at_bodies(loads_look_at_bodies_);
}

void ArticulatedMotion::build(const RobotSpec& robot) {
  robot_ = &robot;
  const std::size_t rotors = machine_.rotors();
  machine_.set(robot);
  if (machine_.rotors() != rotors) make_integrator();
  integrator_->step().take_numbers();
}

void ArticulatedMotion::begin(const StartState& start) {
  integrator_->forget();
  Motion& motion = integrator_->motion();
  const Tree& tree = machine_.tree();
  for (std::vector<double>* numbers :
       {&motion.configuration, &motion.velocities, &motion.accelerations, &motion.integrals})
    std::fill(numbers->begin(), numbers->end(), 0.0);
  tree.begin(*robot_, start.positions, start.velocities, std::span(motion.configuration).first(tree.positions()),
             std::span(motion.velocities).first(tree.dofs()));
  for (const CouplingNumbers& c : machine_.couplings()) {
    motion.configuration[c.position] = c.ratio * motion.configuration[c.leading_position] + c.offset;
    motion.velocities[c.dof] = c.ratio * motion.velocities[c.leading_dof];
  }
  for (std::size_t a = 0; a < motion.integrals.size(); ++a)
    if (machine_.actuators()[a].sample_time > 0.0) motion.integrals[a] = std::nan("");  // nothing read yet
  for (const ActuatorNumbers& actuator : machine_.actuators()) {
    if (!actuator.compliant) continue;
    const CoordinateNumbers& joint = machine_.coordinates()[actuator.coordinate];
    motion.configuration[actuator.position] = motion.configuration[joint.position];
    motion.velocities[actuator.dof] = motion.velocities[joint.dof];
  }
  check();
}

const StepView& ArticulatedMotion::look(double time, bool at_bodies) {
  return integrator_->step().look(integrator_->motion(), time, at_bodies);
}

/// A servo with a sample time holds the force of its last reading.
void ArticulatedMotion::sample_servos(const simulation::StepOrder& order) {
  Motion& motion = integrator_->motion();
  for (std::size_t a = 0; a < motion.integrals.size(); ++a) {
    const ActuatorNumbers& servo = machine_.actuators()[a];
    if (servo.sample_time == 0.0) continue;
    double& held = motion.integrals[a];
    const double now = (order.begin + kSameTime * length_) / servo.sample_time;
    const bool samples = std::isnan(held) || std::floor(now) > std::floor(now - length_ / servo.sample_time);
    if (!samples) continue;
    const double error = order.commands[a] - motion.configuration[servo.position];
    held = std::clamp(servo.kp * error - servo.kd * motion.velocities[servo.dof], -servo.limit, servo.limit);
  }
}

void ArticulatedMotion::advance(const simulation::StepOrder& order) {
  sample_servos(order);
  integrator_->step().ask(order.loads);
  integrator_->advance(order.begin, length_,
                       {.values = order.commands, .rates = order.rates, .end = order.begin + length_}, robot_->gravity);
  check();
}

simulation::SensedForces ArticulatedMotion::sensed_forces() const {
  return {.joint_forces = integrator_->coordinate_forces(), .contact_forces = contact_forces_, .touching = touching_};
}

Eigen::Vector3d ArticulatedMotion::centre_of_mass() const {
  return integrator_->step().centre_of_mass(integrator_->motion());
}

std::vector<std::pair<std::string, std::size_t>> ArticulatedMotion::sections() const {
  const std::size_t coordinates = machine_.coordinates().size(), actuators = machine_.actuators().size();
  return {{"positions", coordinates},
          {"velocities", coordinates},
          {"configuration", machine_.most_positions()},
          {"rates", 2 * machine_.most_dofs()},
          {"actuators", 2 * actuators}};
}

void ArticulatedMotion::save(simulation::StateWriter& writer) const {
  const StepView& view = integrator_->step().look(integrator_->motion(), 0.0, false);
  writer.put(view.positions);
  writer.put(view.velocities);
  const Motion& motion = integrator_->motion();
  put_padded(motion.configuration, machine_.most_positions(), writer);
  put_padded(motion.velocities, machine_.most_dofs(), writer);
  put_padded(motion.accelerations, machine_.most_dofs(), writer);
  writer.put(motion.integrals);
  writer.put(view.actuator_forces);
}

void ArticulatedMotion::load(simulation::StateReader& reader) {
  integrator_->forget();
  reader.skip(2 * machine_.coordinates().size());
  Motion& motion = integrator_->motion();
  reader.get(motion.configuration);
  reader.skip(machine_.most_positions() - machine_.positions());
  reader.get(motion.velocities);
  reader.skip(machine_.most_dofs() - machine_.dofs());
  reader.get(motion.accelerations);
  reader.skip(machine_.most_dofs() - machine_.dofs());
  reader.get(motion.integrals);
  reader.get(integrator_->step().actuator_forces());
  check();
}

void ArticulatedMotion::check() const {
  const Motion& motion = integrator_->motion();
  for (const Link& link : machine_.tree().links())
    for (int i = 0; i < link.dofs; ++i) {
      const double velocity = motion.velocities[nth(link.dof, i)];
      const double position = motion.configuration[nth(link.position, i)];
      if (std::abs(velocity) < kFastest && std::abs(position) < kFarthest) continue;
      throw Error("body \"" + robot_->bodies[static_cast<std::size_t>(link.body)].name + "\" moves at " +
                  number_text(velocity) + " (rad/s or m/s) at " + number_text(position) +
                  " (rad or m); the motion exploded: reduce engine.step, gains or stiffnesses");
    }
}

}  // namespace lacuna::articulated
