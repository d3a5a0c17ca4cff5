#include "fitting/starts/start_states.h"

#include "fitting/numerics/local_polynomial.h"
#include "fitting/starts/restarts.h"
#include "foundation/address.h"
#include "foundation/link_angle.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace lacuna {
namespace {

/// Coordinates are named `joint.hinge`, or `joint.wrist.2` where a joint has several.
std::string coordinate_name(const SensorSpec& sensor, std::size_t which, std::size_t channels) {
  return "joint." + sensor.element + (channels == 1 ? "" : "." + std::to_string(which + 1));
}

std::vector<int> first_coordinates(const RobotSpec& robot) {
  std::vector<int> first;
  int next = 0;
  for (const JointSpec& joint : robot.joints) {
    first.push_back(next);
    next += coordinate_count(joint.kind);
  }
  return first;
}

std::size_t index_of_joint(const RobotSpec& robot, const std::string& name) {
  const auto found =
      std::find_if(robot.joints.begin(), robot.joints.end(), [&](const JointSpec& j) { return j.name == name; });
  return static_cast<std::size_t>(found - robot.joints.begin());
}

/// How many joints lie between a joint and the world.
std::size_t depth_of(const RobotSpec& robot, const JointSpec& joint) {
  const auto above = std::find_if(robot.joints.begin(), robot.joints.end(),
                                  [&](const JointSpec& one) { return one.child == joint.parent; });
  return above == robot.joints.end() ? 0 : 1 + depth_of(robot, *above);
}

/// A robot's state besides its joint coordinates and the commands.
std::string hidden_state(const RobotSpec& robot, const StateLayout& layout) {
  if (has_floating_body(robot)) return "the robot has a floating body";
  const auto holds = [&](const char* name) {
    return std::any_of(layout.begin(), layout.end(),
                       [&](const StateSection& section) { return section.name == name && section.size > 0; });
  };
  if (holds("sensor_delays")) return "a sensor's readings are delayed";
  if (holds("effects")) return "an effect has an internal state";
  for (const ActuatorSpec& actuator : robot.actuators) {
    if (actuator.kind == ActuatorKind::pid && actuator.ki != 0.0)
      return "actuator." + actuator.name + " integrates its error";
    if (std::isfinite(actuator.transmission.stiffness))
      return "the rotor of actuator." + actuator.name + " moves independently of the joint";
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
  order_outward(robot);
  for (const Trial& trial : trials_) {
    readings_.push_back(readings_of(robot, trial, noise));
    restarts_.push_back(restart_interval(robot, trial));
  }
}

void StartStates::order_outward(const RobotSpec& robot) {
  const std::vector<int> first = first_coordinates(robot);
  std::vector<std::pair<std::size_t, int>> depths;
  for (std::size_t j = 0; j < robot.joints.size(); ++j)
    for (int c = 0; c < coordinate_count(robot.joints[j].kind); ++c)
      depths.emplace_back(depth_of(robot, robot.joints[j]), first[j] + c);
  std::stable_sort(depths.begin(), depths.end());
  for (const auto& [depth, coordinate] : depths) outward_.push_back(coordinate);
  for (const CouplingSpec& coupling : robot.couplings)
    followers_.push_back({first[index_of_joint(robot, coupling.joint)], first[index_of_joint(robot, coupling.follows)],
                          coupling.ratio, coupling.offset});
}

StartStates::TrialReadings StartStates::readings_of(const RobotSpec& robot, const Trial& trial,
                                                    const std::vector<ChannelNoise>& noise) const {
  TrialReadings readings;
  readings.positions.resize(names_.size());
  readings.velocities.resize(names_.size());
  for (const Channel& channel : trial.measured.channels)
    for (const ChannelNoise& known : noise)
      if (known.channel == channel.name) readings.deviations.push_back(known.deviation);

  const std::vector<int> first = first_coordinates(robot);
  for (std::size_t j = 0; j < robot.joints.size(); ++j)
    if (robot.joints[j].kind == JointKind::free)
      readings.free.emplace_back(first[j], FreeReading(robot, robot.joints[j], trial.measured, readings.deviations));
  for (const SensorSpec& sensor : robot.sensors) {
    const bool of_link = sensor.kind == SensorKind::link_angle || sensor.kind == SensorKind::link_velocity;
    const bool position = sensor.kind == SensorKind::joint_position || sensor.kind == SensorKind::link_angle;
    if ((!position && !of_link && sensor.kind != SensorKind::joint_velocity) || sensor.scale == 0.0) continue;
    const std::vector<Channel> channels = sensor_channels(robot, sensor);
    for (std::size_t which = 0; which < channels.size(); ++which) {
      const auto column = std::find(trial.measured.channels.begin(), trial.measured.channels.end(), channels[which]);
      const auto name = std::find(names_.begin(), names_.end(), coordinate_name(sensor, which, channels.size()));
      if (column == trial.measured.channels.end() || name == names_.end()) continue;
      auto& slots = position ? readings.positions : readings.velocities;
      auto& slot = slots[static_cast<std::size_t>(name - names_.begin())];
      if (slot) continue;
      slot = Reading{column - trial.measured.channels.begin(), sensor.scale, sensor.offset, {}};
      if (!of_link) continue;
      const std::vector<LinkTurn> turns = turns_of_link(robot, sensor.element);
      for (const LinkTurn& turn : turns)
        if (first[static_cast<std::size_t>(turn.joint)] != name - names_.begin())
          slot->others.emplace_back(first[static_cast<std::size_t>(turn.joint)], turn.sign);
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
    if (!readings_[trial].positions[c] && !follows(static_cast<int>(c)) && !told_by_body(trial, static_cast<int>(c)))
      missing.push_back(names_[c]);
  return missing;
}

bool StartStates::follows(int coordinate) const {
  return std::any_of(followers_.begin(), followers_.end(),
                     [&](const Follower& one) { return one.coordinate == coordinate; });
}

void StartStates::follow(StartEstimate& estimate) const {
  for (const Follower& one : followers_) {
    const auto own = static_cast<std::size_t>(one.coordinate), leader = static_cast<std::size_t>(one.leader);
    estimate.start.positions[own] = one.ratio * estimate.start.positions[leader] + one.offset;
    estimate.start.velocities[own] = one.ratio * estimate.start.velocities[leader];
    estimate.deviation(one.coordinate) = estimate.deviation(coordinates_ + one.coordinate) = 0.0;
  }
}

bool StartStates::told_by_body(std::size_t trial, int coordinate) const {
  return std::any_of(readings_[trial].free.begin(), readings_[trial].free.end(), [&](const auto& free) {
    const int own = coordinate - free.first;
    return own >= 0 && own < 6 && free.second.tells(own);
  });
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
  for (const int c : outward_) {
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
  read_free_joints(stretch, sample, estimate);
  follow(estimate);
  estimate.axes = estimate.deviation.unaryExpr([](double d) { return std::isfinite(d) ? d : 0.0; }).asDiagonal();
  return estimate;
}

void StartStates::read_free_joints(const Stretch& stretch, Eigen::Index sample, StartEstimate& estimate) const {
  const Trial& trial = trials_[stretch.trial];
  for (const auto& [first, reading] : readings_[stretch.trial].free) {
    const auto told = reading.at(trial.measured, {stretch.first, stretch.last}, sample, kHead);
    for (int i = 0; i < 6; ++i) {
      const std::optional<CoordinateReading>& one = told[static_cast<std::size_t>(i)];
      const int position = first + i, velocity = coordinates_ + first + i;
      if (!one || (sample == 0 && given(trial, position))) continue;
      set_component(estimate.start, position, one->position);
      set_component(estimate.start, velocity, one->velocity);
      estimate.deviation(position) = one->position_deviation;
      estimate.deviation(velocity) = one->velocity_deviation;
    }
  }
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
  // The joints before a link are part of its angle, and so is their uncertainty.
  const auto without_others = [&](const Reading& reading, bool rate, double value, double& deviation) {
    for (const auto& [other, sign] : reading.others) {
      const int index = rate ? coordinates_ + other : other;
      value -= sign * component(estimate.start, index);
      deviation = std::hypot(deviation, estimate.deviation(index));
    }
    return value;
  };
  const auto tell_of = [&](const Reading& reading, bool rate, double value, double deviation) {
    value = without_others(reading, rate, value, deviation);
    tell(rate ? velocity : c, value, deviation);
  };
  if (const auto& reading = readings_[stretch.trial].positions[i]) {
    const double noise = deviation(stretch.trial, reading->channel);
    const double unit = std::abs(reading->scale);
    const LocalPolynomial line =
        fit_local_polynomial(measured, reading->channel, {stretch.first, stretch.last}, sample, 2, kHead, noise);
    if (line.points > 0)
      tell_of(*reading, false, (line.value - reading->offset) / reading->scale, line.value_deviation / unit);
    if (line.points > 1) tell_of(*reading, true, line.slope / reading->scale, line.slope_deviation / unit);
  }
  if (const auto& reading = readings_[stretch.trial].velocities[i]) {
    const double noise = deviation(stretch.trial, reading->channel);
    const double unit = std::abs(reading->scale);
    const LocalPolynomial line =
        fit_local_polynomial(measured, reading->channel, {stretch.first, stretch.last}, sample, 1, kHead, noise);
    if (line.points > 0)
      tell_of(*reading, true, (line.value - reading->offset) / reading->scale, line.value_deviation / unit);
  }
}

}  // namespace lacuna
