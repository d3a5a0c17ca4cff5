#include "evaluation/trial_predictor.h"

#include "evaluation/channel_map.h"

#include <lacuna/error.h>

#include <algorithm>

namespace lacuna {
namespace {

constexpr double kMostReadings = 10.0;  ///< intervals of readings that a command interval counts as

double mean_interval(const Eigen::VectorXd& times) {
  return times.size() < 2 ? 0.0 : (times(times.size() - 1) - times(0)) / static_cast<double>(times.size() - 1);
}

void check_shape(const Trial& trial, const CompiledModel& model) {
  const TimeSeries& measured = trial.measured;
  if (measured.samples.rows() != measured.times.size() ||
      measured.samples.cols() != static_cast<Eigen::Index>(measured.channels.size()))
    throw Error("trial " + trial.name + ": its samples do not fit its times and channels");
  if (measured.times.size() == 0) throw Error("trial " + trial.name + " has no samples; leave its file out");
  if (!trial.initial.empty() && trial.initial.size() != model.coordinates().size())
    throw Error("trial " + trial.name + " says where " + std::to_string(trial.initial.size()) +
                " joint coordinates start, but the model has " + std::to_string(model.coordinates().size()));
}

}  // namespace

double command_interval(const Trial& trial) {
  const double between_commands = mean_interval(trial.commands.series.times);
  const double between_readings = mean_interval(trial.measured.times);
  return between_readings > 0.0 ? std::min(between_commands, kMostReadings * between_readings) : between_commands;
}

TrialPredictor::TrialPredictor(const CompiledModel& model, std::vector<Trial> trials, int workers, Timing timing)
    : model_(model), trials_(std::move(trials)), timing_(timing) {
  for (const Trial& trial : trials_) {
    check_shape(trial, model_);
    map_.push_back(match_channels(trial, model_.channels()));
    Test test{trial.commands, trial.measured.times(trial.measured.times.size() - 1), {}};
    if (trial.closed_loop) test.drive = trial.controller;
    tests_.push_back(std::move(test));
  }
  for (int worker = 0; worker < std::max(workers, 1); ++worker) {
    desks_.push_back(std::make_unique<Desk>());
    desks_.back()->workspace = model_.make_workspace();
  }
}

const Test& TrialPredictor::late(Desk& desk, std::size_t trial, double lateness) const {
  const auto* recorded = std::get_if<CommandSeries>(&tests_[trial].drive);
  if (lateness == 0.0 || recorded == nullptr) return tests_[trial];
  if (desk.trial != trial) desk.late = tests_[trial];
  desk.trial = trial;
  std::get<CommandSeries>(desk.late.drive).series.times.array() =
      recorded->series.times.array() + lateness * command_interval(trials_[trial]);
  return desk.late;
}

void TrialPredictor::predict(const Stretch& stretch, std::span<const double> values, const StartState& start,
                             int worker, Prediction& prediction) const {
  Desk& desk = *desks_[static_cast<std::size_t>(worker)];
  const Eigen::VectorXd& times = trials_[stretch.trial].measured.times;
  SimulationOptions& options = desk.options;
  options.start = start;
  options.start_time = times(stretch.first);
  options.end_time = times(stretch.last - 1);
  options.output_times = {times.data() + stretch.first, static_cast<std::size_t>(stretch.size())};
  const bool timed = timing_ == Timing::fitted;
  const Test& test = timed ? late(desk, stretch.trial, values.back()) : tests_[stretch.trial];
  model_.simulate(timed ? values.first(values.size() - 1) : values, test, options, *desk.workspace, desk.result);

  prediction.valid = desk.result.ending == Ending::completed;
  prediction.reason = desk.result.reason;
  const std::vector<Eigen::Index>& map = map_[stretch.trial];
  prediction.samples.resize(stretch.size(), static_cast<Eigen::Index>(map.size()));
  if (!prediction.valid) return;
  for (std::size_t channel = 0; channel < map.size(); ++channel)
    prediction.samples.col(static_cast<Eigen::Index>(channel)) = desk.result.readings.samples.col(map[channel]);
  if (!prediction.samples.allFinite()) {
    prediction.valid = false;
    prediction.reason = "the model reads values that are not finite";
  }
}

void TrialPredictor::residuals(const Stretch& stretch, const Prediction& prediction,
                               TimeSeries::Samples& residuals) const {
  residuals = trials_[stretch.trial].measured.samples.middleRows(stretch.first, stretch.size()) - prediction.samples;
}

}  // namespace lacuna
