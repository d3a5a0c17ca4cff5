#include "fitting/comparison.h"

#include "fitting/floor/free_run.h"
#include "fitting/numerics/progress_meter.h"
#include "fitting/numerics/scored_rms.h"
#include "fitting/scores.h"
#include "fitting/stages.h"
#include "foundation/parallel.h"
#include "measurement/clocks/clock_check.h"
#include "foundation/unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr int kParts = 4;  ///< free runs, as written, horizons, floor
/// Of the larger of error and floor: a tenth of its square. A larger integration error is reported.
constexpr double kCoarseSteps = 0.32;
constexpr double kNoticedRise = 0.01;                               ///< of the error as written
constexpr std::array kUsualHorizons = {0.1, 0.5, 2.0, 10.0, 50.0};  ///< s
constexpr double kFewestSamples = 5.0;                              ///< of a horizon
constexpr double kPartOfTrial = 0.5;                                ///< of the trial's length, that a horizon may have

/// The noise that fit trials show; for channels that only held-out trials have, theirs.
std::vector<ChannelNoise> noise_of(const ComparisonTask& task) {
  if (!task.sensors.empty()) return task.sensors;
  std::vector<Trial> fit_trials;
  for (const Trial& trial : task.trials)
    if (!trial.held_out) fit_trials.push_back(trial);
  std::vector<ChannelNoise> noise = sensor_noise(task.definition.structure.robot, fit_trials);
  for (const ChannelNoise& other : sensor_noise(task.definition.structure.robot, task.trials))
    if (std::none_of(noise.begin(), noise.end(), [&](const auto& one) { return one.channel == other.channel; }))
      noise.push_back(other);
  return noise;
}

/// A run that restarts after a while is scored with the uncertainty of its starts that noise alone causes, as for a
/// right model; a larger one would excuse all errors of a model that does not even follow the first samples.
FreeRun with_start_errors(FreeRun run) {
  if (run.pieces.size() == 1) return run;
  run.start.axes /= run.start.misfit;
  for (RunPiece& piece : run.pieces) piece.start.axes /= piece.start.misfit;
  return run;
}

/// The line of an experiment file that declares it.
std::string declaration_of(const ChannelNoise& noise) {
  const std::string value = fmt::format("{:.2g}", noise.deviation);
  return fmt::format("{} = {{ ..., noise = {} }}", noise.channel,
                     noise.unit == "1" ? value : fmt::format("\"{} {}\"", value, noise.unit));
}

double shortest_restart(const StartStates& states, std::size_t trials) {
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < trials; ++t) shortest = std::min(shortest, states.restart(t));
  return shortest;
}

/// Not longer than a run lasts before it restarts.
std::vector<double> horizons_up_to(double restart, const ComparisonTask& task) {
  if (!task.horizons.empty()) return task.horizons;
  std::vector<double> horizons = usual_horizons(task.trials);
  std::erase_if(horizons, [&](double horizon) { return horizon > restart; });
  return horizons;
}

class Comparer {
 public:
  explicit Comparer(const ComparisonTask& task)
      : task_(task),
        meter_(task.work.progress),
        noise_(noise_of(task)),
        predictor_(task.model, task.trials, task.work),
        states_(task.definition.structure.robot, predictor_, noise_),
        restart_(shortest_restart(states_, task.trials.size())),
        horizons_(horizons_up_to(restart_, task)) {
    meter_.set_parts(kParts);
  }

  Comparison run() {
    compare_free_runs();
    compute_floors();
    score();
    score_as_written();
    score_numerics();
    score_horizons();
    result_.pooled = pool(result_.trials, result_.floors);
    name_restarts();
    name_guessed_noise();
    name_unscored();
    name_coarse_steps();
    name_worse_than_written();
    if (task_.cross_check) result_.cross_check = cross_check(task_, result_);
    result_.seconds = meter_.seconds();
    return std::move(result_);
  }

 private:
  std::size_t trials() const { return task_.trials.size(); }

  std::vector<FreeRun> free_runs(const std::vector<double>& values) const {
    std::vector<FreeRun> runs(trials());
    parallel_for(trials(), predictor_.workers(), [&](std::size_t trial, int worker) {
      task_.work.stop.throw_if_due();
      runs[trial] = free_run(predictor_, states_, trial, values, worker);
    });
    return runs;
  }

  void compare_free_runs() {
    meter_.begin_part("free runs");
    std::vector<FreeRun> runs = free_runs(task_.values);
    from_start_.resize(trials());
    parallel_for(trials(), predictor_.workers(), [&](std::size_t trial, int worker) {
      if (runs[trial].prediction.valid)
        from_start_[trial] = effect_of_start(predictor_, trial, task_.values, with_start_errors(runs[trial]), worker);
    });
    for (const FreeRun& run : runs) {
      const Trial& trial = task_.trials[result_.trials.size()];
      TrialComparison comparison;
      comparison.trial = trial.name;
      comparison.held_out = trial.held_out;
      comparison.valid = run.prediction.valid;
      comparison.reason = run.prediction.reason;
      comparison.start = run.start.start;
      comparison.pieces = run.pieces;
      comparison.first_scored = run.first_scored;
      comparison.times = trial.measured.times;
      comparison.measured = trial.measured.samples;
      comparison.predicted = run.prediction.samples;
      if (comparison.valid) {
        predictor_.residuals(predictor_.whole(result_.trials.size()), run.prediction, comparison.residuals);
      } else {
        comparison.predicted.setConstant(std::numeric_limits<double>::quiet_NaN());
        comparison.residuals = comparison.predicted;
        result_.notes.push_back(trial.name + " cannot be simulated and has no score: " + run.prediction.reason);
      }
      result_.trials.push_back(std::move(comparison));
    }
    meter_.end_part();
  }

  void compute_floors() {
    meter_.begin_part("noise floor");
    std::vector<ScoredStart> starts;
    for (const TrialComparison& trial : result_.trials) starts.push_back({&trial.pieces, trial.first_scored});
    result_.floors = noise_floor({task_.definition, task_.model, task_.trials, task_.noise, task_.values, noise_,
                                  starts, task_.seed, task_.work});
    meter_.end_part();
  }

  void score() {
    for (std::size_t t = 0; t < trials(); ++t)
      for (std::size_t c = 0; c < result_.floors[t].channels.size(); ++c) {
        const auto channel = static_cast<Eigen::Index>(c);
        TrialComparison& trial = result_.trials[t];
        trial.channels.push_back(score_channel(trial, channel, result_.floors[t].channels[c]));
        if (trial.valid) trial.channels.back().from_start = from_start_[t](channel);
      }
  }

  void name_restarts() {
    if (std::ranges::any_of(result_.trials, [](const TrialComparison& trial) { return trial.pieces.size() > 1; }))
      result_.notes.push_back(
          fmt::format("predictions restart from the readings every {:g} s, because recorded torques drive the robot "
                      "without a controller and longer predictions diverge. If a controller made the torques, state it "
                      "in [target.controllers] with drive = \"controllers\" to predict whole recordings",
                      restart_));
  }

  void name_guessed_noise() {
    std::string guesses, line;
    for (const ChannelNoise& noise : noise_) {
      if (!noise.is_guess) continue;
      guesses += fmt::format("{}{} {}", guesses.empty() ? "" : ", ", noise.channel,
                             format_quantity(noise.deviation, noise.unit));
      if (line.empty()) line = declaration_of(noise);
    }
    if (!guesses.empty())
      result_.notes.push_back(fmt::format(
          "noise is estimated from readings in motion, because it is not declared and the channel never rests long "
          "enough: {}. If the data sheet states the noise, declare it under [target.sensors], as in {}",
          guesses, line));
  }

  /// A trial without a sample to score must not look like one without error.
  void name_unscored() {
    for (const TrialComparison& trial : result_.trials)
      if (trial.valid && std::all_of(trial.channels.begin(), trial.channels.end(),
                                     [](const ChannelScore& score) { return score.samples == 0; }))
        result_.notes.push_back(fmt::format(
            "{} has no score: it has no readings after the first {:g} ms, which determine the initial state",
            trial.trial, 1e3 * kHead));
    if (std::none_of(result_.pooled.begin(), result_.pooled.end(), [](const auto& one) { return one.samples > 0; }))
      throw Error(fmt::format("nothing to compare: {}; check the mask, the time ranges and the model",
                              fmt::join(result_.notes, "; ")));
  }

  void score_as_written() {
    meter_.begin_part("as written");
    const std::vector<FreeRun> runs = free_runs(task_.definition.start_values());
    TimeSeries::Samples residuals;
    for (std::size_t t = 0; t < trials(); ++t) {
      if (!runs[t].prediction.valid) continue;
      predictor_.residuals(predictor_.whole(t), runs[t].prediction, residuals);
      for (std::size_t c = 0; c < result_.trials[t].channels.size(); ++c)
        result_.trials[t].channels[c].rmse_as_written =
            scored_rms(residuals, static_cast<Eigen::Index>(c), runs[t].first_scored);
    }
    meter_.end_part();
  }

  /// Change of the prediction by twice the substeps, from the same start.
  void score_numerics() {
    if (task_.finer == nullptr) return;
    const TrialPredictor finer(*task_.finer, task_.trials, task_.work);
    std::vector<Prediction> predictions(trials());
    parallel_for(trials(), finer.workers(), [&](std::size_t t, int worker) {
      predictions[t] = predict_again(finer, t, result_.trials[t].pieces, task_.values, worker);
    });
    for (std::size_t t = 0; t < trials(); ++t) {
      TrialComparison& trial = result_.trials[t];
      if (!predictions[t].valid || !trial.valid) continue;
      const TimeSeries::Samples change = predictions[t].samples - trial.predicted;
      for (std::size_t c = 0; c < trial.channels.size(); ++c)
        trial.channels[c].numerical = scored_rms(change, static_cast<Eigen::Index>(c), trial.first_scored);
    }
  }

  void name_coarse_steps() {
    for (const PooledScore& score : result_.pooled) {
      const double compared = std::fmax(score.floor, score.rmse);
      if (!score.held_out && score.numerical && *score.numerical > kCoarseSteps * compared)
        result_.notes.push_back(
            "the numerical error of " + score.channel +
            " is not small compared with its error and floor; set more engine.substeps, or 0 for automatic");
    }
  }

  /// The fit minimises another error than this one; the user is told.
  void name_worse_than_written() {
    for (const PooledScore& score : result_.pooled)
      if (!score.held_out && score.rmse > (1.0 + kNoticedRise) * score.rmse_as_written)
        result_.notes.push_back(
            fmt::format("{}: the error after the fit is larger than with the values as written: the fit minimises a "
                        "robust error over the horizon of fit.horizon, not the RMSE of a free run (fit.loss = "
                        "\"squared\" counts every reading by its square)",
                        score.channel));
  }

  void score_horizons() {
    meter_.begin_part("horizons");
    for (const double horizon : horizons_) add_horizon(horizon, false);
    const double longest = automatic_horizon(predictor_, states_, task_.values, kHead);
    result_.start_horizon = longest;
    const bool adds = std::none_of(horizons_.begin(), horizons_.end(), [&](double h) { return h >= longest; });
    if (adds && std::isfinite(longest)) add_horizon(longest, true);
    meter_.end_part();
  }

  void add_horizon(double horizon, bool automatic) {
    for (std::size_t t = 0; t < trials(); ++t) {
      if (!states_.reconstructible(t)) continue;
      HorizonScore score = restarted(t, horizon);
      score.automatic = automatic;
      if (!score.rmse.empty()) result_.trials[t].horizons.push_back(std::move(score));
    }
  }

  /// Stretches of a first part, which determines the start, and a horizon, one horizon apart.
  std::vector<Stretch> horizon_stretches(std::size_t trial, double horizon) const {
    const Eigen::VectorXd& times = task_.trials[trial].measured.times;
    const double* begin = times.data();
    const double* end = begin + times.size();
    const double last = times(times.size() - 1);
    std::vector<Stretch> stretches;
    for (double at = times(0); at + kHead + horizon <= last * (1.0 + 1e-12); at += horizon)
      stretches.push_back({trial, std::lower_bound(begin, end, at) - begin,
                           std::upper_bound(begin, end, at + kHead + horizon) - begin});
    return stretches;
  }

  /// Residuals and RMS over all stretches; empty if the trial is shorter than one.
  HorizonScore restarted(std::size_t trial, double horizon) const {
    HorizonScore score{.horizon = horizon};
    const std::vector<Stretch> stretches = horizon_stretches(trial, horizon);
    if (stretches.empty()) return score;
    std::vector<TimeSeries::Samples> residuals(stretches.size());
    parallel_for(stretches.size(), predictor_.workers(), [&](std::size_t k, int worker) {
      task_.work.stop.throw_if_due();
      const StartEstimate start = fit_head(predictor_, states_, stretches[k], task_.values, worker);
      Prediction prediction;
      if (start.valid) predictor_.predict(stretches[k], task_.values, start.start, worker, prediction);
      if (!prediction.valid) return;
      TimeSeries::Samples all;
      predictor_.residuals(stretches[k], prediction, all);
      const Eigen::Index head = first_scored(predictor_, stretches[k], start) - stretches[k].first;
      residuals[k] = all.bottomRows(all.rows() - head);
    });
    const TimeSeries::Samples& measured = task_.trials[trial].measured.samples;
    score.rmse = rms_of(residuals, measured.cols());
    score.residuals.setConstant(measured.rows(), measured.cols(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t k = 0; k < stretches.size(); ++k) {
      if (residuals[k].size() == 0) continue;  // could not be simulated
      const Eigen::Index first = stretches[k].last - residuals[k].rows();
      score.residuals.middleRows(first, residuals[k].rows()) = residuals[k];
      score.restarts.push_back(first);
    }
    return score;
  }

  static std::vector<double> rms_of(const std::vector<TimeSeries::Samples>& residuals, Eigen::Index channels) {
    std::vector<double> rmse;
    for (Eigen::Index channel = 0; channel < channels; ++channel) {
      double squares = 0.0, count = 0.0;
      for (const TimeSeries::Samples& stretch : residuals)
        for (Eigen::Index row = 0; row < stretch.rows(); ++row)
          if (std::isfinite(stretch(row, channel))) {
            squares += stretch(row, channel) * stretch(row, channel);
            count += 1.0;
          }
      rmse.push_back(count > 0.0 ? std::sqrt(squares / count) : std::numeric_limits<double>::quiet_NaN());
    }
    return rmse;
  }

  const ComparisonTask& task_;
  ProgressMeter meter_;
  std::vector<ChannelNoise> noise_;
  TrialPredictor predictor_;
  StartStates states_;
  const double restart_;                     ///< s, infinite: all runs go on to the end of their trials
  const std::vector<double> horizons_;       ///< s
  std::vector<Eigen::VectorXd> from_start_;  ///< per trial and channel
  Comparison result_;
};

/// Without the samples at which nothing was measured, such as repeated readings that were left out.
std::vector<double> times_measured(const TimeSeries& measured) {
  std::vector<double> times;
  for (Eigen::Index row = 0; row < measured.times.size(); ++row)
    if (measured.samples.row(row).array().isFinite().any()) times.push_back(measured.times(row));
  return times;
}

}  // namespace

std::vector<double> usual_horizons(const std::vector<Trial>& trials) {
  double interval = 0.0, longest = 0.0;
  for (const Trial& trial : trials) {
    const std::vector<double> times = times_measured(trial.measured);
    if (times.size() < 2) continue;
    interval = std::max(interval, median_interval(times));
    longest = std::max(longest, times.back() - times.front());
  }
  std::vector<double> horizons;
  for (const double horizon : kUsualHorizons)
    if (horizon >= kFewestSamples * interval && horizon <= kPartOfTrial * longest) horizons.push_back(horizon);
  return horizons;
}

Comparison compare(const ComparisonTask& task) { return Comparer(task).run(); }

std::unique_ptr<CompiledModel> compile_finer(const ModelDefinition& definition) {
  EngineSettings finer = definition.engine;
  finer.substeps *= 2;
  return compile(definition.structure, finer);
}

}  // namespace lacuna
