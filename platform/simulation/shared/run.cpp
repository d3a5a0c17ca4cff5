#include "simulation/shared/run.h"

#include "foundation/address.h"
#include "foundation/text/number_text.h"
#include "foundation/processes/process_limits.h"
#include "simulation/shared/sensor_imperfections.h"

#include <lacuna/error.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna::simulation {
namespace {

constexpr double kSameTime = 1e-9;  // integration steps

std::string seconds(double time) { return number_text(time) + " s"; }

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

Run::Run(const EngineModel& model, EngineWorkspace& workspace, const SimulationOptions& options,
         SimulationResult& result)
    : model_(model),
      ws_(workspace),
      options_(options),
      result_(result),
      h_(model.step()),
      tolerance_(kSameTime * h_),
      look_at_bodies_(workspace.sensors.reads_bodies() || model.effects().looks_at_bodies()),
      origin_(options.start_time) {}

void Run::carry_out(std::span<const double> parameters, const Test& test) {
  check_arguments(parameters);
  const ParameterSlots::Slots& slots = model_.slots().of(test.setup);
  ws_.drive.open_source(test, model_.structure().robot);
  if (options_.from) read_saved_clock();
  check_output_times(time(step_));
  prepare_result();
  try {
    ws_.build(parameters, slots);
    ws_.drive.open_delays(ws_.instance.robot());
    begin();
    record_lateness();
    bool wanted = write_outputs(time(step_), time(step_));
    while (wanted && step_ < last_step_) {
      options_.stop.throw_if_kept_waiting();
      advance();
      wanted = write_outputs(time(step_ - 1), time(step_));
    }
    result_.ending = wanted ? Ending::completed : Ending::stopped;
    finish();
  } catch (const Interrupted&) {
    ws_.drop_motion();
    throw;
  } catch (const EngineFailure& failure) {
    ws_.drop_motion();
    fail(failure.what());
  } catch (const std::bad_alloc&) {
    ws_.drop_motion();
    if (!ws_.effects.runs_one()) throw Error(no_memory_sentence());  // which is not a fault of the model
    fail(ws_.effects.explain());
  } catch (...) {
    fail(ws_.effects.explain());
  }
  ws_.effects.end();
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
    throw Error("the output times extend from " + seconds(times.front()) + " to " + seconds(times.back()) +
                ", beyond the simulation from " + seconds(start) + " to " + seconds(options_.end_time));
}

void Run::read_saved_clock() {
  const std::size_t expected = model_.state_size() + ws_.drive.controller_state_size();
  if (options_.from->values.size() != expected)
    throw Error("the saved state has " + std::to_string(options_.from->values.size()) +
                " values, this model and controller need " + std::to_string(expected));
  std::tie(origin_, step_) = EngineWorkspace::saved_clock(*options_.from);
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
  if (options_.from)
    ws_.load(*options_.from);
  else
    begin_at_coordinates();
  if (options_.record_centre_of_mass) centre_ = ws_.motion->centre_of_mass();
  const double steps = std::ceil((options_.end_time - origin_) / h_ - kSameTime);
  if (steps > 1e15) throw Error("the simulation has too many steps");
  last_step_ = std::max(step_, static_cast<std::uint64_t>(std::max(0.0, steps)));
}

void Run::record_lateness() {
  if (!options_.record_lateness) return;
  result_.lateness.assign(model_.channels().size(), 0.0);
  const std::vector<SensorSpec>& sensors = ws_.instance.robot().sensors;
  const std::span<const std::size_t> first = ws_.sensors.first_channel();
  for (std::size_t s = 0; s < sensors.size(); ++s) {
    const double begins = options_.restart ? options_.restart_time : time(step_);
    const double late = sensors[s].delay + ws_.effects.lateness(s, begins);
    std::fill(result_.lateness.begin() + static_cast<std::ptrdiff_t>(first[s]),
              result_.lateness.begin() + static_cast<std::ptrdiff_t>(first[s + 1]), late);
  }
}

void Run::begin_at_coordinates() {
  ws_.motion->begin(options_.start);
  const StepView& view = ws_.motion->look(origin_, look_at_bodies_);
  ws_.effects.start(view);
  ws_.sensors.start(view, ws_.motion->sensed_forces(), ws_.effects);
  if (!ws_.drive.closed_loop()) recall_commands();
}

/// Lags and limits begin with the command before the start.
void Run::recall_commands() {
  const StepView& view = ws_.motion->look(origin_, look_at_bodies_);
  for (std::size_t a = 0; a < ws_.commands.size(); ++a)
    ws_.last_commands[a] = received(a, ws_.drive.command_before(a, origin_), view);
}

void Run::advance() {
  take_commands(ws_.motion->look(time(step_), model_.effects().looks_at_bodies()));
  write_commands(time(step_ + 1) - tolerance_);
  ws_.motion->advance({.begin = time(step_),
                       .commands = ws_.commands,
                       .rates = ws_.command_rates,
                       .loads = model_.effects().acts_in_steps() ? this : nullptr});
  std::copy(ws_.commands.begin(), ws_.commands.end(), ws_.last_commands.begin());
  ++step_;
  ++result_.steps;
  if (options_.restart && std::abs(time(step_) - options_.restart_time) < 0.5 * h_) restart();
  if (options_.record_centre_of_mass) {
    centre_before_ = centre_;
    centre_ = ws_.motion->centre_of_mass();
  }
  sense(time(step_));
}

void Run::restart() {
  const StepView& view = ws_.motion->look(time(step_), false);
  StartState& start = ws_.restart;
  start = *options_.restart;
  const auto keep = [](std::span<const double> now, std::vector<double>& values) {
    for (std::size_t c = 0; c < values.size(); ++c)
      if (std::isnan(values[c])) values[c] = now[c];
  };
  keep(view.positions, start.positions);
  keep(view.velocities, start.velocities);
  ws_.motion->begin(start);
}

void Run::add_loads(const StepView& view, double length, StepLoads& loads) {
  ws_.effects.add_loads(view, length, loads);
}
void Run::advance(const StepView& view, double length) { ws_.effects.advance(view, length); }

void Run::take_commands(const StepView& view) {
  if (ws_.drive.acts(step_)) {
    std::copy(ws_.sensors.readings().begin(), ws_.sensors.readings().end(), ws_.output_row.begin());
    impair(time(step_));
    ws_.drive.act(time(step_), ws_.output_row);
  }
  ws_.drive.begin_step(time(step_), step_ == 0);
  for (std::size_t a = 0; a < ws_.commands.size(); ++a) take_command(a, view);
}

double Run::received(std::size_t a, double sent, const StepView& view) {
  if (std::isnan(sent) && ws_.drive.may_be_off()) return sent;
  const ActuatorSpec& actuator = ws_.instance.robot().actuators[a];
  const double passed_on = ws_.effects.command(a, actuator.gain * sent + actuator.offset, view);
  return std::clamp(passed_on, actuator.command_lower, actuator.command_upper);
}

void Run::take_command(std::size_t a, const StepView& view) {
  const double command = received(a, ws_.drive.command(a), view);
  const bool is_off = std::isnan(command) && ws_.drive.may_be_off();
  if (is_off && ws_.instance.robot().actuators[a].kind == ActuatorKind::motion)
    throw Error("actuator \"" + ws_.instance.robot().actuators[a].name + "\" imposes a motion and cannot be off");
  if (!std::isfinite(command) && !is_off)
    throw Error("the command of actuator \"" + ws_.instance.robot().actuators[a].name + "\" is " +
                number_text(command));
  ws_.commands[a] = command;
  if (step_ == 0 && ws_.drive.closed_loop()) ws_.last_commands[a] = command;
  const double rate = (command - ws_.last_commands[a]) / h_;
  ws_.command_rates[a] = std::isnan(rate) ? 0.0 : rate;
}

void Run::sense(double now) {
  if (!readings_wanted(now)) return;
  const StepView& view = ws_.motion->look(now, look_at_bodies_);
  std::copy(ws_.sensors.readings().begin(), ws_.sensors.readings().end(), ws_.readings_before.begin());
  ws_.sensors.advance(view, ws_.motion->sensed_forces(), ws_.effects);
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
  add_imperfections(ws_.instance.robot().sensors, ws_.sensors.first_channel(), options_.imperfections->seed, now, h_,
                    ws_.output_row);
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

}  // namespace lacuna::simulation
