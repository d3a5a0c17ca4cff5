#include "evaluation/scoring/model_scorer.h"

#include "evaluation/model/channel_map.h"
#include "foundation/plugins/plugin_fault.h"

#include <lacuna/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kWorst = std::numeric_limits<double>::infinity();

std::size_t scored_samples(const ScoredTrial& scored) {
  return static_cast<std::size_t>(scored.trial.measured.times.size() - scored.first_sample);
}

ComparisonShape shape_of(std::span<const ScoredTrial> trials) {
  ComparisonShape shape;
  for (const ScoredTrial& scored : trials) {
    ++shape.trials;
    shape.samples += scored_samples(scored);
    shape.channels = scored.trial.measured.channels.size();
  }
  return shape;
}

StartState start_of(const Trial& trial) {
  StartState start;
  for (const InitialValue& value : trial.initial) {
    start.positions.push_back(value.position);
    start.velocities.push_back(value.velocity);
  }
  return start;
}

}  // namespace

/// Workspace of one thread.
struct ModelScorer::Desk {
  CandidateSimulator candidate;
  std::vector<SimulationOptions> options = {};  // per trial
  SimulationResult result = {};
  std::unique_ptr<ScoreAccumulator> total = {};
  std::vector<std::unique_ptr<ScoreAccumulator>> trials = {};
  std::vector<double> predicted = {};
  bool reads_finite = true;     // all readings of the current candidate
  TrialReadings readings = {};  // of the trials, where delays are fitted for a candidate
  ModelProposal unlagged = {};
};

/// Compares samples while they are simulated.
struct ModelScorer::Tally {
  const ScoredTrial& scored;
  std::span<const Eigen::Index> map;  // indices from the trial's channels to the model's
  const ComponentOrigin& metric;
  ScoreAccumulator& total;
  ScoreAccumulator& of_trial;
  std::vector<double>& predicted;
  double bar;
  std::string fault;
  bool abandoned = false;
  bool reads_finite = true;  // the model's readings so far

  /// Whether the simulation may end early.
  bool take(std::size_t sample, std::span<const double> readings) {
    const auto row = static_cast<Eigen::Index>(sample);
    if (row < scored.first_sample) return false;
    for (std::size_t i = 0; i < map.size(); ++i) predicted[i] = readings[static_cast<std::size_t>(map[i])];
    return add(row, predicted);
  }

  /// The same for readings in the order of the measured channels.
  bool add(Eigen::Index row, std::span<const double> ordered) {
    const TimeSeries::Samples& measured = scored.trial.measured.samples;
    for (const double reading : ordered) reads_finite = reads_finite && std::isfinite(reading);
    const PluginCall call(on_page(metric), "add");
    try {
      const std::span<const double> of_row(measured.data() + row * measured.cols(), ordered.size());
      total.add(ordered, of_row);
      of_trial.add(ordered, of_row);
      abandoned = total.bound() > bar;
      throw_if_arithmetic_changed("add");
    } catch (...) {
      fault = describe_current_exception(metric, "add");
    }
    return abandoned || !fault.empty();
  }
};

ModelScorer::ModelScorer(const CompiledModel& model, std::vector<ScoredTrial> trials, Chosen<FitnessMetric> metric,
                         const Work& work, const ModelDefinition* definition, const std::vector<std::size_t>& profiled)
    : trials_(std::move(trials)), metric_(std::move(metric)) {
  for (const ScoredTrial& scored : trials_) {
    maps_.push_back(match_channels(scored.trial, model.channels()));
    if (scored.trial.measured.channels.size() != trials_.front().trial.measured.channels.size())
      throw Error("trial " + scored.trial.name + " measures other channels than trial " + trials_.front().trial.name +
                  "; one score needs the same channels in all trials");
  }
  if (definition) lags_ = LagProfile(*definition, profiled, trials_);
  const auto accumulator = [&](std::span<const ScoredTrial> of) {
    return guarded_call(metric_.origin, "accumulator",
                        [&] { return metric_->accumulator(shape_of(of), metric_.parameters); });
  };
  for (int worker = 0; worker < std::max(work.threads, 1); ++worker) {
    auto simulator = std::make_unique<Desk>(Desk{CandidateSimulator(model, definition)});
    simulator->total = accumulator(trials_);
    for (const ScoredTrial& scored : trials_) {
      simulator->trials.push_back(accumulator({&scored, 1}));
      SimulationOptions& options = simulator->options.emplace_back();
      const Eigen::VectorXd& times = scored.trial.measured.times;
      options.stop = work.stop;
      options.start = start_of(scored.trial);
      options.start_time = times(0);
      options.end_time = times(times.size() - 1);
      options.output_times = {times.data(), static_cast<std::size_t>(times.size())};
    }
    if (!trials_.empty()) simulator->predicted.resize(maps_.front().size());
    simulators_.push_back(std::move(simulator));
  }
}

ModelScorer::~ModelScorer() = default;

void ModelScorer::score(const ModelProposal& candidate, std::optional<double> bar, int worker,
                        ModelScore& result) const {
  Desk& simulator = *simulators_[static_cast<std::size_t>(worker)];
  result.trials.clear();
  result.kind = ScoreKind::full;
  result.reason.clear();
  result.steps = 0;
  result.values.clear();
  simulator.reads_finite = true;
  guarded_call(metric_.origin, "reset", [&] { simulator.total->reset(); });
  if (lags_.empty())
    score_trials(candidate, bar.value_or(kWorst), simulator, result);
  else
    score_with_lags(candidate, bar.value_or(kWorst), simulator, result);
  switch (result.kind) {
    case ScoreKind::full:
      result.total = guarded_call(metric_.origin, "score", [&] { return simulator.total->score(); });
      break;
    case ScoreKind::abandoned:
      result.total = guarded_call(metric_.origin, "bound", [&] { return simulator.total->bound(); });
      break;
    case ScoreKind::invalid: result.total = kWorst; break;
  }
  if (result.kind == ScoreKind::invalid || std::isfinite(result.total)) return;
  result.kind = ScoreKind::invalid;
  result.reason = why_not_finite(simulator, result.total);
  result.total = kWorst;
}

/// The metric's score, or its bound, of a candidate all of whose simulations came to their end.
std::string ModelScorer::why_not_finite(const Desk& simulator, double score) const {
  if (!simulator.reads_finite) return "the model predicts readings that are not finite";
  const bool measured = std::any_of(trials_.begin(), trials_.end(), [](const ScoredTrial& scored) {
    return scored.trial.measured.samples.bottomRows(static_cast<Eigen::Index>(scored_samples(scored)))
        .array()
        .isFinite()
        .any();
  });
  if (!measured) return "no trial has a reading from which a score could be computed";
  return fmt::format("{}: its score is {}, although all readings of the model are finite{}", to_string(metric_.origin),
                     score,
                     std::isnan(score) ? kFaultOfPlugin : ": the error is too large for it, or the metric is faulty");
}

void ModelScorer::score_trials(const ModelProposal& candidate, double bar, Desk& simulator, ModelScore& result) const {
  try {
    simulator.candidate.take(candidate);
  } catch (const Error& error) {
    result.kind = ScoreKind::invalid;
    result.reason = error.what();
  }
  for (std::size_t t = 0; t < trials_.size() && result.kind == ScoreKind::full; ++t)
    score_trial(t, bar, simulator, result);
}

void ModelScorer::score_trial(std::size_t t, double bar, Desk& simulator, ModelScore& result) const {
  ScoreAccumulator& of_trial = *simulator.trials[t];
  guarded_call(metric_.origin, "reset", [&] { of_trial.reset(); });
  Tally tally{trials_[t], maps_[t], metric_.origin, *simulator.total, of_trial, simulator.predicted, bar, {}};
  SimulationOptions& options = simulator.options[t];
  options.stop_when = [&tally](std::size_t sample, std::span<const double> readings) {
    return tally.take(sample, readings);
  };
  simulator.candidate.simulate(trials_[t].test, options, simulator.result);
  result.steps += simulator.result.steps;
  if (simulator.result.ending == Ending::invalid && tally.fault.empty()) tally.fault = simulator.result.reason;
  simulator.reads_finite = simulator.reads_finite && tally.reads_finite;
  end_trial(t, tally, result);
}

void ModelScorer::end_trial(std::size_t t, const Tally& tally, ModelScore& result) const {
  if (!tally.fault.empty()) {
    result.kind = ScoreKind::invalid;
    result.reason = "trial " + std::to_string(t) + ", " + tally.fault;
  } else if (tally.abandoned) {
    result.kind = ScoreKind::abandoned;
  }
  result.trials.push_back(guarded_call(metric_.origin, "score", [&] {
    return result.kind == ScoreKind::full ? tally.of_trial.score() : tally.of_trial.bound();
  }));
}

/// All trials are simulated first, because a delay is common to all of them.
void ModelScorer::score_with_lags(const ModelProposal& candidate, double bar, Desk& simulator,
                                  ModelScore& result) const {
  simulator.unlagged = candidate;
  lags_.clear_delays(simulator.unlagged.values);
  if (!read_trials(simulator.unlagged, simulator, result)) return;
  result.values = candidate.values;
  lags_.fit(simulator.readings, result.values);
  for (std::size_t t = 0; t < trials_.size() && result.kind == ScoreKind::full; ++t) {
    ScoreAccumulator& of_trial = *simulator.trials[t];
    guarded_call(metric_.origin, "reset", [&] { of_trial.reset(); });
    Tally tally{trials_[t], {}, metric_.origin, *simulator.total, of_trial, simulator.predicted, bar, {}};
    const TimeSeries::Samples& readings = simulator.readings[t];
    for (Eigen::Index row = trials_[t].first_sample; row < readings.rows(); ++row)
      if (tally.add(row, {readings.data() + row * readings.cols(), static_cast<std::size_t>(readings.cols())})) break;
    simulator.reads_finite = simulator.reads_finite && tally.reads_finite;
    end_trial(t, tally, result);
  }
}

bool ModelScorer::read_trials(const ModelProposal& candidate, Desk& simulator, ModelScore& result) const {
  simulator.readings.resize(trials_.size());
  try {
    simulator.candidate.take(candidate);
  } catch (const Error& error) {
    result.kind = ScoreKind::invalid;
    result.reason = error.what();
    return false;
  }
  for (std::size_t t = 0; t < trials_.size(); ++t) {
    simulator.options[t].stop_when = nullptr;
    simulator.candidate.simulate(trials_[t].test, simulator.options[t], simulator.result);
    result.steps += simulator.result.steps;
    if (simulator.result.ending == Ending::invalid) {
      result.kind = ScoreKind::invalid;
      result.reason = "trial " + std::to_string(t) + ", " + simulator.result.reason;
      return false;
    }
    const TimeSeries::Samples& all = simulator.result.readings.samples;
    simulator.readings[t].resize(all.rows(), static_cast<Eigen::Index>(maps_[t].size()));
    for (std::size_t c = 0; c < maps_[t].size(); ++c)
      simulator.readings[t].col(static_cast<Eigen::Index>(c)) = all.col(maps_[t][c]);
  }
  return true;
}

}  // namespace lacuna
