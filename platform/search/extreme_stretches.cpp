#include "search/extreme_stretches.h"

#include <algorithm>
#include <array>
#include <limits>

namespace lacuna {
namespace {

/// Readings of one channel in a stretch.
std::vector<double> readings_of(const PredictedStretch& stretch, const std::vector<Trial>& trials,
                                std::size_t channel) {
  std::vector<double> values;
  const TimeSeries::Samples& samples = trials[stretch.stretch.trial].measured.samples;
  for (std::size_t i = 0; i < stretch.rows.size(); ++i)
    if (stretch.channels[i] == channel)
      values.push_back(samples(stretch.stretch.first + stretch.rows[i], stretch.columns[i]));
  return values;
}

/// The stretches of the middle length with the largest and smallest reading of a channel and the steepest rise and
/// fall: there limits are reached.
std::vector<PredictedStretch> extremes(const PredictionLadder& ladder, const std::vector<Trial>& trials,
                                       std::size_t channel) {
  constexpr std::size_t kFigures = 4;
  std::array<double, kFigures> most;
  most.fill(-std::numeric_limits<double>::infinity());
  std::array<const PredictedStretch*, kFigures> farthest{};
  for (const PredictedStretch& stretch : ladder.stretches) {
    if (stretch.length != ladder.lengths.size() / 2) continue;
    const std::vector<double> values = readings_of(stretch, trials, channel);
    if (values.empty()) continue;
    const auto [least, largest] = std::minmax_element(values.begin(), values.end());
    const double rise = values.back() - values.front();
    const std::array<double, kFigures> figures = {*largest, -*least, rise, -rise};
    for (std::size_t f = 0; f < kFigures; ++f)
      if (figures[f] > most[f]) most[f] = figures[f], farthest[f] = &stretch;
  }
  std::vector<PredictedStretch> found;
  for (std::size_t f = 0; f < kFigures; ++f)
    if (farthest[f] && std::find(farthest.begin(), farthest.begin() + f, farthest[f]) == farthest.begin() + f)
      found.push_back(*farthest[f]);
  return found;
}

}  // namespace

std::string joint_at(const RobotSpec& robot, const std::string& where) {
  const std::string kind = where.substr(0, where.find('.')), rest = where.substr(where.find('.') + 1);
  std::string name = rest.substr(0, rest.find('.'));
  if (kind == "joint") return name;
  for (const ActuatorSpec& actuator : robot.actuators)
    if (kind == "actuator" && name == actuator.name) return actuator.joint;
  for (const SensorSpec& sensor : robot.sensors)
    if (kind == "sensor" && name == sensor.name) return sensor.element;
  return {};
}

PredictionLadder for_sizes(const PredictionLadder& ladder, const RobotSpec& robot, const std::vector<Trial>& trials,
                           const std::string& joint) {
  PredictionLadder few = thinned(ladder, 1);
  std::erase_if(few.stretches,
                [&](const PredictedStretch& stretch) { return stretch.length != ladder.lengths.size() / 2; });
  const std::vector<std::string> joints = joints_of(robot, ladder.noise);
  for (std::size_t channel = 0; channel < joints.size(); ++channel)
    if (joints[channel] == joint)
      for (PredictedStretch& stretch : extremes(ladder, trials, channel)) few.stretches.push_back(std::move(stretch));
  return few;
}

}  // namespace lacuna
