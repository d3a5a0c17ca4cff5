#include "evaluation/prediction/trial_predictor.h"

#include "evaluation/model/channel_map.h"
#include "evaluation/prediction/holding_commands.h"

#include <lacuna/error.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kMostReadings = 10.0;  ///< longest command interval, in intervals of readings
constexpr double kLongestDelay = 1.0;   ///< s: longest command delay of the library

double mean_interval(const Eigen::VectorXd& times) {
  return times.size() < 2 ? 0.0 : (times(times.size() - 1) - times(0)) / static_cast<double>(times.size() - 1);
}

void check_shape(const Trial& trial, const CompiledModel& model) {
  const TimeSeries& measured = trial.measured;
  if (measured.samples.rows() != measured.times.size() ||
      measured.samples.cols() != static_cast<Eigen::Index>(measured.channels.size()))
    throw Error("trial " + trial.name + ": the size of its samples does not match its times and channels");
  if (measured.times.size() == 0) throw Error("trial " + trial.name + " has no samples; leave its file out");
  if (!trial.initial.empty() && trial.initial.size() != model.coordinates().size())
    throw Error("trial " + trial.name + " gives initial values for " + std::to_string(trial.initial.size()) +
                " joint coordinates, but the model has " + std::to_string(model.coordinates().size()));
}

bool starts_at_rest(const Trial& trial) {
  return !trial.initial.empty() && std::all_of(trial.initial.begin(), trial.initial.end(), [](const auto& value) {
    return value.knowledge == InitialKnowledge::given && value.velocity == 0.0;
  });
}

/// First channels of quaternions: `turn.w`, `turn.x`, `turn.y`, `turn.z`.
std::vector<Eigen::Index> quaternions_in(const std::vector<Channel>& channels) {
  std::vector<Eigen::Index> first;
  for (std::size_t c = 0; c + 3 < channels.size(); ++c) {
    const std::string& name = channels[c].name;
    if (!name.ends_with(".w")) continue;
    const std::string sensor = name.substr(0, name.size() - 1);
    if (channels[c + 1].name == sensor + "x" && channels[c + 2].name == sensor + "y" &&
        channels[c + 3].name == sensor + "z")
      first.push_back(static_cast<Eigen::Index>(c));
  }
  return first;
}

bool is_force(const std::string& unit) { return unit == "N*m" || unit == "N"; }

}  // namespace

double command_interval(const Trial& trial) {
  const double between_commands = mean_interval(trial.commands.series.times);
  const double between_readings = mean_interval(trial.measured.times);
  return between_readings > 0.0 ? std::min(between_commands, kMostReadings * between_readings) : between_commands;
}

TrialPredictor::TrialPredictor(const CompiledModel& model, std::vector<Trial> trials, const Work& work, Timing timing)
    : model_(model), trials_(std::move(trials)), timing_(timing), stop_(work.stop) {
  for (Trial& trial : trials_) {
    check_shape(trial, model_);
    pasts_.push_back(past_of(trial));
    map_.push_back(match_channels(trial, model_.channels()));
    orientations_.push_back(quaternions_in(trial.measured.channels));
    Test test{trial.commands, trial.measured.times(trial.measured.times.size() - 1), {}, trial.setup.name};
    if (trial.closed_loop) test.drive = trial.controller;
    tests_.push_back(std::move(test));
  }
  for (int worker = 0; worker < std::max(work.threads, 1); ++worker) {
    simulators_.push_back(std::make_unique<Desk>());
    simulators_.back()->workspace = model_.make_workspace();
    simulators_.back()->options.record_lateness = true;
    simulators_.back()->options.stop = stop_;
  }
}

TrialPredictor::Past TrialPredictor::past_of(Trial& trial) const {
  std::vector<double>& before = trial.commands.before;
  const TimeSeries& series = trial.commands.series;
  if (before.empty() || series.times.size() == 0 || trial.closed_loop) return Past::known;
  const bool at_rest = starts_at_rest(trial);
  for (std::size_t c = 0; at_rest && c < before.size();
       ++c)  // whatever holds the robot: an actuator that is off was off before
    if (std::isnan(before[c]) && is_force(series.channels[c].unit) &&
        series.samples(0, static_cast<Eigen::Index>(c)) == 0.0)
      before[c] = 0.0;
  if (std::none_of(before.begin(), before.end(), [](double value) { return std::isnan(value); })) return Past::known;
  return at_rest ? Past::held_still : Past::unknown;
}

const Test& TrialPredictor::test_for(Desk& simulator, const Stretch& stretch, std::span<const double> values,
                                     double lateness) const {
  const Trial& trial = trials_[stretch.trial];
  const Test& test = tests_[stretch.trial];
  const auto* recorded = std::get_if<CommandSeries>(&test.drive);
  const Eigen::VectorXd& times = trial.measured.times;
  const bool held_still = pasts_[stretch.trial] == Past::held_still &&
                          (model_.has_memory() || timing_ == Timing::fitted) &&
                          times(stretch.first) - times(0) <= kLongestDelay;
  if (recorded == nullptr || (lateness == 0.0 && !held_still)) return test;
  if (simulator.trial != stretch.trial) simulator.own = test;
  simulator.trial = stretch.trial;
  auto& own = std::get<CommandSeries>(simulator.own.drive);
  own.series.times.array() = recorded->series.times.array() + lateness * command_interval(trial);
  if (!held_still) return simulator.own;
  std::vector<double> positions;
  for (const InitialValue& value : trial.initial) positions.push_back(value.position);
  own.before = holding_commands(model_, values, recorded->series.channels, recorded->before, positions, test.setup,
                                *simulator.workspace)
                   .value_or(recorded->before);
  return simulator.own;
}

void TrialPredictor::predict(const Stretch& stretch, std::span<const double> values, const StartState& start,
                             int worker, Prediction& prediction, const WarmUp* warm_up) const {
  Desk& simulator = *simulators_[static_cast<std::size_t>(worker)];
  const Eigen::VectorXd& times = trials_[stretch.trial].measured.times;
  SimulationOptions& options = simulator.options;
  options.start = start;
  options.start_time = times(stretch.first);
  options.restart = nullptr;
  if (warm_up && warm_up->first < stretch.first) {
    options.restart = &start;
    options.restart_time = options.start_time;
    options.start = warm_up->start;
    const double step = model_.step();
    options.start_time -= std::ceil((options.restart_time - times(warm_up->first)) / step - 1e-6) * step;
  }
  options.end_time = times(stretch.last - 1);
  options.output_times = {times.data() + stretch.first, static_cast<std::size_t>(stretch.size())};
  const bool timed = timing_ == Timing::fitted;
  const std::span<const double> own = timed ? values.first(values.size() - 1) : values;
  const Test& test = test_for(simulator, stretch, own, timed ? values.back() : 0.0);
  model_.simulate(own, test, options, *simulator.workspace, simulator.result);

  prediction.valid = simulator.result.ending == Ending::completed;
  prediction.reason = simulator.result.reason;
  const std::vector<Eigen::Index>& map = map_[stretch.trial];
  prediction.samples.resize(stretch.size(), static_cast<Eigen::Index>(map.size()));
  if (!prediction.valid) return;
  prediction.lateness.resize(map.size());
  for (std::size_t channel = 0; channel < map.size(); ++channel) {
    prediction.samples.col(static_cast<Eigen::Index>(channel)) = simulator.result.readings.samples.col(map[channel]);
    prediction.lateness[channel] =
        simulator.result.lateness.empty() ? 0.0 : simulator.result.lateness[static_cast<std::size_t>(map[channel])];
  }
  align_orientations(stretch, prediction.samples);
  if (!prediction.samples.allFinite()) {
    prediction.valid = false;
    prediction.reason = "the model predicts readings that are not finite";
  }
}

void TrialPredictor::align_orientations(const Stretch& stretch, TimeSeries::Samples& samples) const {
  for (const Eigen::Index first : orientations_[stretch.trial])
    for (Eigen::Index row = 0; row < stretch.size(); ++row) {
      const auto measured = trials_[stretch.trial].measured.samples.row(stretch.first + row).segment(first, 4);
      auto predicted = samples.row(row).segment(first, 4);
      if (measured.dot(predicted) < 0.0) predicted = -predicted;
    }
}

void TrialPredictor::residuals(const Stretch& stretch, const Prediction& prediction,
                               TimeSeries::Samples& residuals) const {
  residuals = trials_[stretch.trial].measured.samples.middleRows(stretch.first, stretch.size()) - prediction.samples;
}

}  // namespace lacuna
