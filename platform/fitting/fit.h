#pragma once

#include <lacuna/trial.h>

#include "evaluation/model/model_definition.h"
#include "fitting/floor/noise_floor.h"
#include "foundation/work.h"

#include <cstdint>
#include <string>
#include <vector>

namespace lacuna {

/// The input of a fit. Everything that it refers to must live until `fit` returns.
struct FitTask {
  const ModelDefinition& definition;
  const CompiledModel& model;        ///< compiled from `definition`
  const std::vector<Trial>& trials;  ///< held-out ones are not looked at
  FitSection options;
  std::uint64_t seed = 1;
  Work work = {};
  /// At the time limit of `work`: lift it and return the best values so far, or throw `TimeIsUp`.
  bool best_at_time_limit = false;
};

/// A free value after the fit. Intervals account for residuals that are correlated in time.
struct FittedValue {
  std::string address;
  std::string unit;
  double start = 0.0;
  double value = 0.0;
  double standard_error = 0.0;  ///< infinite where the data do not determine the value, NaN at a bound
  double lower_95 = 0.0;        ///< NaN at a bound; the bound where the data do not determine the value
  double upper_95 = 0.0;
  bool at_lower_bound = false;
  bool at_upper_bound = false;
  bool identified = true;  ///< false: see `FitResult::cannot_tell`
};

/// One round of the fit: all data cut into segments of one length. `values` show whether an effect's size depends on
/// the length.
struct FitStage {
  std::string name;            ///< "segments of 0.1 s", "free run"
  double segment = 0.0;        ///< s; 0: whole trials
  int segments = 0;            ///< how many
  int starts = 0;              ///< starting points that were refined in this stage
  int agreeing = 0;            ///< of these, how many reached the same error as the best
  int iterations = 0;          ///< of the best
  bool converged = false;      ///< the best one's
  double residual = 0.0;       ///< RMS of residual over sensor noise, of the best one
  std::vector<double> values;  ///< of the best one, in the order of `ModelDefinition::free`
};

struct FitResult {
  std::vector<FittedValue> values;  ///< in the order of `ModelDefinition::free`
  Eigen::MatrixXd covariance;       ///< of the values; rows and columns of values at a bound or not identified are NaN
  std::vector<FitStage> stages;     ///< in their order; the result is that of the last one
  int starts = 0;                   ///< starting points tried
  int agreeing = 0;                 ///< of these, how many reached the same error in the first stage
  std::vector<std::string> cannot_tell;   ///< one sentence per combination that the data do not determine
  std::vector<std::string> notes;         ///< decisions that the fit made, sentences
  std::vector<ChannelNoise> noise;        ///< the sensor noise by which residuals were weighted
  std::uint64_t simulations = 0;          ///< stretches simulated
  std::uint64_t invalid_simulations = 0;  ///< of these, how many failed
  std::size_t samples = 0;                ///< number of measured values in the last stage
  double correlation_time = 0.0;          ///< of the residual, s
  double seconds = 0.0;                   ///< wall clock
  bool stopped = false;                   ///< by the time limit: the best values so far, without intervals

  /// The fitted values alone.
  std::vector<double> parameters() const;
};

/// Finds the free values with which the model predicts the trials best, by METHOD's step 4: stages of growing segments,
/// whose initial states are fitted with them and do not count as fitted values, then the last horizon; from several
/// starts; with Huber's loss. Where the stages lead away from the start values of effects, these are tried once more in
/// the last stage, beside the base that fits best with them. A model without free values gives a result without values.
/// The same digits for any number of threads. Throws `Error` if there is nothing to fit to or no starting point can be
/// simulated, and `Interrupted`.
///
/// Literature: H. G. Bock, "Recent advances in parameter identification techniques for O.D.E.", 1983 (multiple
/// shooting); D. W. Marquardt, 1963; P. J. Huber, 1964; H. White, 1982, and A. C. Cameron and D. L. Miller, 2015
/// (covariance by blocks).
FitResult fit(const FitTask& task);

/// The result of not fitting (`--as-is`): values as they stand, no intervals.
FitResult as_written(const ModelDefinition& definition);

}  // namespace lacuna
