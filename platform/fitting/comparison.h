#pragma once

#include "fitting/cross_check.h"
#include "fitting/error_parts.h"
#include "fitting/floor/free_run.h"
#include "fitting/floor/noise_floor.h"
#include "foundation/work.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// The input of a comparison. Everything that it refers to must live until `compare` returns.
struct ComparisonTask {
  const ModelDefinition& definition;
  const CompiledModel& model;        ///< compiled from `definition`
  const std::vector<Trial>& trials;  ///< fit and held out
  const NoiseSection& noise;
  std::vector<double> values;  ///< fitted values, in the order of `ModelDefinition::free`
  /// The same model with twice the substeps (`compile_finer`); null: the numerical share is not computed.
  const CompiledModel* finer = nullptr;
  std::vector<double> horizons = {};  ///< s, scored beside the free run; empty: `usual_horizons`
  std::uint64_t seed = 1;
  Work work = {};
  bool cross_check = false;                ///< with the other engine
  std::vector<ChannelNoise> sensors = {};  ///< of every measured channel; empty: `sensor_noise` of the trials
};

/// Prediction error of one channel, over the scored samples. Residual = measured − predicted.
struct ChannelScore {
  std::string channel;
  std::string unit;
  std::size_t samples = 0;  ///< number of samples to score; 0, or a trial that cannot be simulated: all figures are NaN
  double rmse = 0.0;        ///< channel unit
  double floor = 0.0;       ///< channel unit
  double times_floor = 0.0;      ///< rmse/floor
  double normalised_rmse = 0.0;  ///< rmse over the standard deviation of the measurement
  double bias = 0.0;             ///< mean residual, channel unit
  ErrorParts parts;
  double max_error = 0.0;           ///< largest |residual|, channel unit
  double max_error_time = 0.0;      ///< s, in the trial's time
  double rmse_as_written = 0.0;     ///< of the same free run with the start values of the file
  std::optional<double> numerical;  ///< RMS change of the prediction by twice the substeps
  double from_start = 0.0;          ///< RMS change of the prediction by one standard error of the initial state
};

/// The error of predictions over a horizon: the trial is cut into stretches; each starts from a state estimated on its
/// first 50 ms, and the time after these is scored.
struct HorizonScore {
  double horizon = 0.0;                     ///< s
  bool automatic = false;                   ///< `Comparison::start_horizon`, where that is longer than the others
  std::vector<double> rmse = {};            ///< one per channel; NaN where nothing could be scored
  std::vector<Eigen::Index> restarts = {};  ///< samples at which a stretch begins to be scored
  TimeSeries::Samples residuals = {};       ///< samples × channels of the trial; NaN where nothing was scored
};

/// One trial: a free run from an initial state that was estimated on the first 50 ms, which are not scored (given
/// initial states are used as they are, and everything is scored).
struct TrialComparison {
  std::string trial;
  bool held_out = false;
  bool valid = true;
  std::string reason;  ///< why the simulation failed, if it did
  std::vector<ChannelScore> channels;
  std::vector<HorizonScore> horizons;
  StartState start;               ///< at the first sample
  std::vector<RunPiece> pieces;   ///< of the run; several where it restarts after a while (restarts.h)
  Eigen::Index first_scored = 0;  ///< sample
  /// For figures; samples × channels of the trial. NaN where there is no value.
  Eigen::VectorXd times;
  TimeSeries::Samples measured, predicted, residuals;
};

/// A channel over all fit trials, or over all held-out trials. If one of them cannot be simulated there is no total
/// error: `rmse` and `times_floor` are NaN, so that a model never gains by failing on its hardest trial. The other
/// figures are then of the trials that could be simulated.
struct PooledScore {
  std::string channel;
  std::string unit;
  bool held_out = false;
  std::size_t samples = 0;  ///< that were scored
  int failed_trials = 0;    ///< trials with readings to score, but without a prediction
  double rmse = 0.0;
  double floor = 0.0;  ///< NaN where it is not known for one trial
  double times_floor = 0.0;
  double from_start = 0.0;  ///< see ChannelScore
  double rmse_as_written = 0.0;
  std::optional<double> numerical;
  std::string worst_trial;
  double worst_time = 0.0;  ///< s
  std::string floor_origin;
};

/// 0.1 to 50 s, each four or five times as long as the one before, up to half of the trials' length and as far as they
/// have samples. The same for every model of these recordings.
std::vector<double> usual_horizons(const std::vector<Trial>& trials);

struct Comparison {
  std::vector<TrialComparison> trials;  ///< in the order of the task
  std::vector<PooledScore> pooled;      ///< by channel, fit before held out
  std::vector<TrialFloor> floors;       ///< one a trial
  /// s; up to this horizon a start from 50 ms of data stays within twice the noise; infinite: always.
  double start_horizon = 0.0;
  std::optional<CrossCheck> cross_check;  ///< only where it was requested
  std::vector<std::string> notes;
  double seconds = 0.0;
};

/// Compares the model, with the given values, with every trial. Only initial states are fitted. Held-out trials are
/// read here: the caller counts the look. Throws `Error` where the trials do not fit the model or none of them can be
/// scored, and `Interrupted`.
Comparison compare(const ComparisonTask& task);

/// The definition compiled with twice the substeps, for the numerical share.
std::unique_ptr<CompiledModel> compile_finer(const ModelDefinition& definition);

}  // namespace lacuna
