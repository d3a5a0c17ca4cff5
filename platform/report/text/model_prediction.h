#pragma once

#include <lacuna/time_series.h>

#include "evaluation/model/known_setups.h"

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// What one model says of a trial or of a test.
struct PredictedPart {
  std::string name;  ///< of the trial, or the test as it was asked for
  Eigen::VectorXd times;
  std::vector<Channel> channels;
  TimeSeries::Samples predicted;      ///< samples × channels, in the channels' units
  TimeSeries::Samples measured = {};  ///< the same; of no size where nothing was measured
  std::vector<double> rmse = {};      ///< one a channel that was measured, where it is scored, as in a comparison
};

/// An experiment's model alone, simulated.
struct ModelPrediction {
  std::string experiment;
  int revision = 0;
  std::size_t fitted_values = 0;  ///< 0: the values are as they are written
  std::string test;               ///< as it was asked for; empty: the trials
  std::optional<KnownSetup> setup;
  bool setup_is_asked = false;
  std::size_t held_out = 0;  ///< trials, which are not looked at
  std::vector<PredictedPart> parts;
  std::vector<std::string> failed;  ///< sentences: what cannot be simulated, and why
};

/// A line a channel of each trial or of the test, and that a single model has no spread.
std::string model_prediction_text(const ModelPrediction& prediction);

}  // namespace lacuna
