#include "simulation/ode/run.h"

#include "foundation/address.h"
#include "simulation/ode/session.h"
#include "simulation/shared/sensor_imperfections.h"

#include <lacuna/error.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna::ode {
namespace {

constexpr double kSameTime = 1e-9;  // integration steps

std::string seconds(double time) { return std::to_string(time) + " s"; }

void size_series(TimeSeries& series, const std::vector<Channel>& channels, std::span<const double> times) {
  if (series.channels != channels) series.channels = channels;
  const auto rows = static_cast<Eigen::Index>(times.size());
  series.times = Eigen::Map<const Eigen::VectorXd>(times.data(), rows);
  series.samples.resize(rows, static_cast<Eigen::Index>(channels.size()));
  series.samples.setConstant(std::numeric_limits<double>::quiet_NaN());
}

const std::vector<Channel>& centre_of_mass_channels() {
  static const std::vector<Channel> channels = {{"x", "m"}, {"y", "m"}, {"z", "m"}};
  return channels;
}

}  // namespace

Run::Run(const OdeModel& model, OdeWorkspace& workspace, const SimulationOptions& options, SimulationResult& result)
    : model_(model),
      ws_(workspace),
      options_(options),
      result_(result),
      h_(model.step()),
      tolerance_(kSameTime * h_),
      look_at_bodies_(workspace.sensors.reads_bodies() || model.effects().looks_at_state()),
      origin_(options.start_time) {}

void Run::carry_out(std::span<const double> parameters, const Test& test) {
  join_session();
  check_arguments(parameters);
  ws_.drive.open_source(test, model_.structure().robot);
  if (options_.from) read_saved_clock();
  check_output_times(time(step_));
  prepare_result();
  try {
    ws_.build(parameters);
    ws_.drive.open_delays(ws_.instance.robot());
    begin();
    bool wanted = write_outputs(time(step_), time(step_));
    while (wanted && step_ < last_step_) {
      advance();
      wanted = write_outputs(time(step_ - 1), time(step_));
    }
    result_.ending = wanted ? Ending::completed : Ending::stopped;
    finish();
  } catch (const EngineFailure& failure) {
    ws_.drop_mechanism();
    fail(failure.what());
  } catch (...) {
    fail(ws_.effects.explain());
  }
}

void Run::check_arguments(std::span<const double> parameters) const {
  if (parameters.size() != model_.slots().parameters().size())
    throw Error("the model takes " + std::to_string(model_.slots().parameters().size()) + " parameters, " +
                std::to_string(parameters.size()) + " were given");
  const auto coordinates = static_cast<std::size_t>(model_.tree().coordinates);
  for (const auto& [name, values] :
       {std::pair{"positions", &options_.start.positions}, std::pair{"velocities", &options_.start.velocities}})
    if (!values->empty() && values->size() != coordinates)
      throw Error("the start state has " + std::to_string(values->size()) + " " + name + ", the robot has " +
                  std::to_string(coordinates) + " joint coordinates");
  if (!std::isfinite(options_.end_time) || !std::isfinite(options_.start_time))
    throw Error("a simulation needs finite start and end times");
}

void Run::check_output_times(double start) const {
  const auto times = options_.output_times;
  if (!std::is_sorted(times.begin(), times.end())) throw Error("the output times must ascend");
  if (!times.empty() && !(times.front() >= start - tolerance_ && times.back() <= options_.end_time + tolerance_))
    throw Error("the output times reach from " + seconds(times.front()) + " to " + seconds(times.back()) +
                ", beyond the simulation from " + seconds(start) + " to " + seconds(options_.end_time));
}

void Run::read_saved_clock() {
  const std::size_t expected = model_.state_size() + ws_.drive.controller_state_size();
  if (options_.from->values.size() != expected)
    throw Error("the saved state has " + std::to_string(options_.from->values.size()) +
                " values, this model and controller need " + std::to_string(expected));
  std::tie(origin_, step_) = OdeWorkspace::saved_clock(*options_.from);
}

void Run::prepare_result() {
  result_.reason.clear();
  result_.steps = 0;
  size_series(result_.readings, model_.channels(), options_.output_times);
  if (options_.record_commands)
    size_series(result_.commands, command_channels(model_.structure().robot), options_.output_times);
  else
    result_.commands = {};
  if (options_.record_centre_of_mass)
    size_series(result_.centre_of_mass, centre_of_mass_channels(), options_.output_times);
  else
    result_.centre_of_mass = {};
  result_.final_state.values.clear();
  if (options_.save_final_state)
    result_.final_state.values.reserve(model_.state_size() + ws_.drive.controller_state_size());
}

void Run::begin() {
  const RobotSpec& robot = ws_.instance.robot();
  contact_ = robot.contact;
  gravity_ = robot.gravity;
  if (options_.from)
    begin_at_saved_state();
  else
    begin_at_coordinates();
  if (options_.record_centre_of_mass) centre_ = ws_.mechanism->bodies().centre_of_mass();
  const double steps = std::ceil((options_.end_time - origin_) / h_ - kSameTime);
  if (steps > 1e15) throw Error("the simulation has too many steps");
  last_step_ = std::max(step_, static_cast<std::uint64_t>(std::max(0.0, steps)));
}

void Run::begin_at_coordinates() {
  const RobotSpec& robot = ws_.instance.robot();
  Mechanism& mechanism = *ws_.mechanism;
  simulation::place_bodies(robot, model_.tree(), options_.start, ws_.start_motions);
  mechanism.bodies().place(ws_.start_motions);
  std::fill(ws_.joint_forces.begin(), ws_.joint_forces.end(), 0.0);
  if (options_.start.positions.empty())
    mechanism.joints().set_positions(ws_.joint_forces);  // zeros
  else
    mechanism.joints().set_positions(options_.start.positions);
  mechanism.joints().update();
  mechanism.check_bodies();
  mechanism.ground().collide(contact_.slope);
  for (std::size_t a = 0; a < ws_.memories.size(); ++a) {
    const std::size_t coordinate = ws_.places[a].coordinate;
    ws_.memories[a] = {.rotor_position = mechanism.joints().positions()[coordinate],
                       .rotor_velocity = mechanism.joints().velocities()[coordinate]};
  }
  ws_.look(origin_, look_at_bodies_);
  ws_.effects.start(ws_.view);
  ws_.sensors.start(ws_.view, ws_.sensed_forces(), ws_.effects);
  if (!ws_.drive.closed_loop()) recall_commands();
}

/// Lags and limits begin with what was commanded before the start.
void Run::recall_commands() {
  for (std::size_t a = 0; a < ws_.memories.size(); ++a)
    ws_.memories[a].last_command = received(a, ws_.drive.command_before(a, origin_));
}

void Run::begin_at_saved_state() {
  ws_.load(*options_.from);
  ws_.mechanism->check_bodies();
  ws_.mechanism->ground().collide(contact_.slope);
}

void Run::advance() {
  ws_.look(time(step_), model_.effects().looks_at_state());
  take_commands();
  write_commands(time(step_ + 1) - tolerance_);
  const auto base = ws_.mechanism->base_loads();
  std::copy(base.begin(), base.end(), ws_.loads.begin());
  if (!model_.effects().before_step().empty()) ask_effects();
  for (std::size_t a = 0; a < ws_.commands.size(); ++a) apply_actuator(a);

  ws_.mechanism->step(ws_.loads, contact_);
  ++step_;
  ++result_.steps;
  if (options_.record_centre_of_mass) {
    centre_before_ = centre_;
    centre_ = ws_.mechanism->bodies().centre_of_mass();
  }
  settle_actuators();
  ws_.sum_joint_forces();
  sense(time(step_));
}

void Run::take_commands() {
  if (ws_.drive.acts(step_)) {
    std::copy(ws_.sensors.readings().begin(), ws_.sensors.readings().end(), ws_.output_row.begin());
    impair(time(step_));
    ws_.drive.act(time(step_), ws_.output_row);
  }
  ws_.drive.begin_step(time(step_), step_ == 0);
  for (std::size_t a = 0; a < ws_.commands.size(); ++a) take_command(a);
}

double Run::received(std::size_t a, double sent) {
  const ActuatorSpec& actuator = ws_.instance.robot().actuators[a];
  const double passed_on = ws_.effects.command(a, actuator.gain * sent + actuator.offset, ws_.view);
  return std::clamp(passed_on, actuator.command_lower, actuator.command_upper);
}

void Run::take_command(std::size_t a) {
  const ActuatorSpec& actuator = ws_.instance.robot().actuators[a];
  const double command = received(a, ws_.drive.command(a));
  if (!std::isfinite(command))
    throw Error("the command of actuator \"" + actuator.name + "\" is " + std::to_string(command));
  ws_.commands[a] = command;
  simulation::ActuatorMemory& memory = ws_.memories[a];
  if (step_ == 0 && ws_.drive.closed_loop()) memory.last_command = command;
  const bool compliant = ws_.places[a].compliant;
  const double position =
      compliant ? memory.rotor_position : ws_.mechanism->joints().positions()[ws_.places[a].coordinate];
  ws_.laws[a] = simulation::actuator_law(actuator, command, position, memory, h_);
  if (!compliant && actuator.kind == ActuatorKind::force) ws_.actuator_forces[a] = memory.force = ws_.laws[a].force;
}

void Run::ask_effects() {
  const RobotSpec& robot = ws_.instance.robot();
  std::fill(ws_.body_loads.begin(), ws_.body_loads.end(), BodyLoad{});
  contact_ = robot.contact;
  gravity_ = robot.gravity;
  StepLoads loads{.joints = ws_.loads, .bodies = ws_.body_loads, .contact = contact_, .gravity = gravity_};
  ws_.effects.before_step(ws_.view, loads);
  ws_.mechanism->set_gravity(gravity_);
  for (std::size_t i = 0; i < ws_.body_loads.size(); ++i) ws_.mechanism->add_body_load(i, ws_.body_loads[i]);
}

void Run::apply_actuator(std::size_t a) {
  const ActuatorPlace& place = ws_.places[a];
  JointLoad& load = ws_.loads[place.coordinate];
  if (place.servo) {
    ws_.mechanism->set_servo(a, ws_.laws[a]);
  } else if (!place.compliant) {
    load.force += ws_.memories[a].force;
  } else {
    const Joints& joints = ws_.mechanism->joints();
    ws_.transmissions[a].emplace(ws_.instance.robot().actuators[a].transmission, ws_.memories[a], ws_.laws[a],
                                 joints.positions()[place.coordinate], joints.velocities()[place.coordinate], h_);
    load.force += ws_.transmissions[a]->joint_force();
    load.damping += ws_.transmissions[a]->joint_damping();
  }
}

void Run::settle_actuators() {
  for (std::size_t a = 0; a < ws_.memories.size(); ++a) {
    const ActuatorPlace& place = ws_.places[a];
    const ActuatorSpec& actuator = ws_.instance.robot().actuators[a];
    simulation::ActuatorMemory& memory = ws_.memories[a];
    const double velocity = ws_.mechanism->row_velocity(place.coordinate);
    double motor_force = 0.0;
    if (place.servo) motor_force = memory.force = ws_.laws[a].at(velocity);
    if (place.compliant) {
      ws_.transmissions[a]->advance(velocity, memory);
      motor_force = ws_.laws[a].at(memory.rotor_velocity);
    }
    if (actuator.kind != ActuatorKind::pid) continue;
    const double position =
        place.compliant ? memory.rotor_position : ws_.mechanism->joints().positions()[place.coordinate];
    simulation::remember_pid(actuator, ws_.commands[a], position, motor_force, h_, memory);
  }
}

void Run::sense(double now) {
  const bool wanted = readings_wanted(now);
  const bool after = !model_.effects().after_step().empty();
  if (!wanted && !after) return;
  ws_.look(now, look_at_bodies_);
  if (after) ws_.effects.after_step(ws_.view);
  if (!wanted) return;
  std::copy(ws_.sensors.readings().begin(), ws_.sensors.readings().end(), ws_.readings_before.begin());
  ws_.sensors.advance(ws_.view, ws_.sensed_forces(), ws_.effects);
}

bool Run::readings_wanted(double now) const {
  if (ws_.sensors.has_memory() || model_.effects().any_sense() || ws_.drive.closed_loop() || step_ == last_step_)
    return true;
  return next_output_ < options_.output_times.size() && options_.output_times[next_output_] < now + h_;
}

bool Run::write_outputs(double before, double now) {
  const auto now_readings = ws_.sensors.readings();
  for (; next_output_ < options_.output_times.size(); ++next_output_) {
    const double wanted = options_.output_times[next_output_];
    if (wanted > now + tolerance_) break;
    const double share = now - wanted <= tolerance_ ? 1.0 : std::max(0.0, (wanted - before) / h_);
    for (std::size_t i = 0; i < ws_.output_row.size(); ++i)
      ws_.output_row[i] =
          share == 1.0 ? now_readings[i] : ws_.readings_before[i] + share * (now_readings[i] - ws_.readings_before[i]);
    impair(wanted);
    const auto row = static_cast<Eigen::Index>(next_output_);
    if (options_.record_centre_of_mass)
      result_.centre_of_mass.samples.row(row) = (centre_before_ + share * (centre_ - centre_before_)).transpose();
    std::copy(ws_.output_row.begin(), ws_.output_row.end(), result_.readings.samples.row(row).begin());
    if (options_.stop_when && options_.stop_when(next_output_, ws_.output_row)) return false;
  }
  return true;
}

void Run::impair(double now) {
  if (!options_.imperfections) return;
  simulation::add_imperfections(ws_.instance.robot().sensors, ws_.sensors.first_channel(), options_.imperfections->seed,
                                now, h_, ws_.output_row);
}

void Run::write_commands(double until) {
  if (!options_.record_commands) return;
  for (; next_command_output_ < options_.output_times.size(); ++next_command_output_) {
    const double wanted = options_.output_times[next_command_output_];
    if (wanted >= until) break;
    const auto row = static_cast<Eigen::Index>(next_command_output_);
    for (std::size_t a = 0; a < ws_.commands.size(); ++a)
      result_.commands.samples(row, static_cast<Eigen::Index>(a)) = ws_.drive.sent(a, wanted);
  }
}

void Run::finish() {
  if (result_.ending == Ending::completed) write_commands(kInfinity);
  if (options_.save_final_state) ws_.save(origin_, step_, result_.final_state);
}

void Run::fail(const std::string& what) {
  result_.ending = Ending::invalid;
  result_.final_state.values.clear();
  result_.reason = "at " + seconds(time(step_)) + ": " + what;
}

}  // namespace lacuna::ode
