#include "fitting/start_states.h"

#include "fitting/local_polynomial.h"
#include "foundation/address.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace lacuna {
namespace {

/// Coordinates are named `joint.hinge`, or `joint.wrist.2` where a joint has several.
std::string coordinate_name(const SensorSpec& sensor, std::size_t which, std::size_t channels) {
  return "joint." + sensor.element + (channels == 1 ? "" : "." + std::to_string(which + 1));
}

/// What a robot's state holds besides its joint coordinates and what was commanded.
std::string hidden_state(const RobotSpec& robot, const StateLayout& layout) {
  if (has_floating_body(robot)) return "the robot has a body that floats";
  const auto holds = [&](const char* name) {
    return std::any_of(layout.begin(), layout.end(),
                       [&](const StateSection& section) { return section.name == name && section.size > 0; });
  };
  if (holds("sensor_delays")) return "a sensor's readings are delayed";
  if (holds("effects")) return "an effect has a state of its own";
  for (const ActuatorSpec& actuator : robot.actuators) {
    if (actuator.kind == ActuatorKind::pid && actuator.ki != 0.0)
      return "actuator." + actuator.name + " integrates its error";
    if (std::isfinite(actuator.transmission.stiffness))
      return "the rotor of actuator." + actuator.name + " moves by itself";
  }
  return {};
}

}  // namespace

bool has_floating_body(const RobotSpec& robot) {
  std::set<std::string> held;
  for (const JointSpec& joint : robot.joints) held.insert(joint.child);
  return std::any_of(robot.bodies.begin(), robot.bodies.end(),
                     [&](const BodySpec& body) { return !held.contains(body.name); });
}

double component(const StartState& start, int index) {
  const auto i = static_cast<std::size_t>(index);
  const std::size_t n = start.positions.size();
  return i < n ? start.positions[i] : start.velocities[i - n];
}

void set_component(StartState& start, int index, double value) {
  const auto i = static_cast<std::size_t>(index);
  const std::size_t n = start.positions.size();
  (i < n ? start.positions[i] : start.velocities[i - n]) = value;
}

StartState moved_along(const StartEstimate& estimate, Eigen::Index axis, double times) {
  StartState start = estimate.start;
  for (int index = 0; index < estimate.axes.rows(); ++index)
    set_component(start, index, component(start, index) + times * estimate.axes(index, axis));
  return start;
}

StartStates::StartStates(const RobotSpec& robot, const TrialPredictor& predictor,
                         const std::vector<ChannelNoise>& noise)
    : trials_(predictor.trials()), coordinates_(static_cast<int>(predictor.model().coordinates().size())) {
  hidden_ = hidden_state(robot, predictor.model().state_layout());
  for (const Coordinate& coordinate : predictor.model().coordinates()) names_.push_back(coordinate.name);
  for (const Trial& trial : trials_) readings_.push_back(readings_of(robot, trial, noise));
}

StartStates::TrialReadings StartStates::readings_of(const RobotSpec& robot, const Trial& trial,
                                                    const std::vector<ChannelNoise>& noise) const {
  TrialReadings readings;
  readings.positions.resize(names_.size());
  readings.velocities.resize(names_.size());
  for (const Channel& channel : trial.measured.channels)
    for (const ChannelNoise& known : noise)
      if (known.channel == channel.name) readings.deviations.push_back(known.deviation);

  for (const SensorSpec& sensor : robot.sensors) {
    const bool position = sensor.kind == SensorKind::joint_position;
    if ((!position && sensor.kind != SensorKind::joint_velocity) || sensor.scale == 0.0) continue;
    const std::vector<Channel> channels = sensor_channels(robot, sensor);
    for (std::size_t which = 0; which < channels.size(); ++which) {
      const auto column = std::find(trial.measured.channels.begin(), trial.measured.channels.end(), channels[which]);
      const auto name = std::find(names_.begin(), names_.end(), coordinate_name(sensor, which, channels.size()));
      if (column == trial.measured.channels.end() || name == names_.end()) continue;
      auto& slots = position ? readings.positions : readings.velocities;
      auto& slot = slots[static_cast<std::size_t>(name - names_.begin())];
      if (!slot) slot = Reading{column - trial.measured.channels.begin(), sensor.scale, sensor.offset};
    }
  }
  return readings;
}

std::string StartStates::obstacle(std::size_t trial) const {
  const std::vector<std::string> missing = unmeasured(trial);
  return missing.empty() ? hidden_ : missing.front() + " has no measured position";
}

std::vector<std::string> StartStates::unmeasured(std::size_t trial) const {
  std::vector<std::string> missing;
  for (std::size_t c = 0; c < names_.size(); ++c)
    if (!readings_[trial].positions[c]) missing.push_back(names_[c]);
  return missing;
}

double StartStates::deviation(std::size_t trial, Eigen::Index channel) const {
  return readings_[trial].deviations[static_cast<std::size_t>(channel)];
}

bool StartStates::given(const Trial& trial, int coordinate) {
  return !trial.initial.empty() &&
         trial.initial[static_cast<std::size_t>(coordinate)].knowledge == InitialKnowledge::given;
}

StartEstimate StartStates::from_samples(const Stretch& stretch, Eigen::Index sample) const {
  const Trial& trial = trials_[stretch.trial];
  const auto n = static_cast<std::size_t>(coordinates_);
  StartEstimate estimate;
  estimate.valid = true;
  estimate.start.positions.assign(n, 0.0);
  estimate.start.velocities.assign(n, 0.0);
  estimate.deviation =
      Eigen::VectorXd::Constant(Eigen::Index{2} * coordinates_, std::numeric_limits<double>::infinity());
  for (int c = 0; c < coordinates_; ++c) {
    const auto i = static_cast<std::size_t>(c);
    if (sample == 0 && !trial.initial.empty()) {
      estimate.start.positions[i] = trial.initial[i].position;
      estimate.start.velocities[i] = trial.initial[i].velocity;
    }
    if (sample == 0 && given(trial, c))
      estimate.deviation(c) = estimate.deviation(coordinates_ + c) = 0.0;
    else
      read_coordinate(stretch, sample, c, estimate);
  }
  estimate.axes = estimate.deviation.unaryExpr([](double d) { return std::isfinite(d) ? d : 0.0; }).asDiagonal();
  return estimate;
}

void StartStates::read_coordinate(const Stretch& stretch, Eigen::Index sample, int c, StartEstimate& estimate) const {
  const auto i = static_cast<std::size_t>(c);
  const int velocity = coordinates_ + c;
  const TimeSeries& measured = trials_[stretch.trial].measured;
  const auto tell = [&](int index, double value, double deviation) {
    if (!(deviation < estimate.deviation(index))) return;
    set_component(estimate.start, index, value);
    estimate.deviation(index) = deviation;
  };
  if (const auto& reading = readings_[stretch.trial].positions[i]) {
    const double noise = deviation(stretch.trial, reading->channel);
    const double unit = std::abs(reading->scale);
    const LocalPolynomial line =
        fit_local_polynomial(measured, reading->channel, {stretch.first, stretch.last}, sample, 2, kHead, noise);
    if (line.points > 0) tell(c, (line.value - reading->offset) / reading->scale, line.value_deviation / unit);
    if (line.points > 1) tell(velocity, line.slope / reading->scale, line.slope_deviation / unit);
  }
  if (const auto& reading = readings_[stretch.trial].velocities[i]) {
    const double noise = deviation(stretch.trial, reading->channel);
    const double unit = std::abs(reading->scale);
    const LocalPolynomial line =
        fit_local_polynomial(measured, reading->channel, {stretch.first, stretch.last}, sample, 1, kHead, noise);
    if (line.points > 0) tell(velocity, (line.value - reading->offset) / reading->scale, line.value_deviation / unit);
  }
}

}  // namespace lacuna
