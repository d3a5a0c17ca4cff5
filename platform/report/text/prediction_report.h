#pragma once

#include "eea/ensemble/ensemble_prediction.h"
#include "evaluation/model/known_setups.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lacuna {

/// The trial that a test became, where it was carried out.
struct MeasuredTest {
  int trial = 0;        ///< its number in the run
  bool fitted = false;  ///< the models were fitted to it
  TimeSeries measured;
};

/// Prediction of a test by several models of a run, with its calibration.
struct PredictionReport {
  std::string experiment;
  std::int64_t run = 0;
  int pass = 0;
  std::string test;                      ///< as it was asked for
  double duration = 0.0;                 ///< s
  std::optional<KnownSetup> setup = {};  ///< that it is made in; nothing where no recording has one
  bool setup_is_asked = false;           ///< else it is the first recording's
  std::vector<std::pair<std::string, std::size_t>> structures;  ///< of the models, and how many have it
  std::size_t copies = 0;                                       ///< of models, which do not count
  std::size_t refuted = 0;                                      ///< models left out (PassEnsemble)
  std::vector<std::string> unscored;                            ///< channels on which no model was scored
  std::vector<double> noise;                                    ///< of a reading, one a channel (PassEnsemble)
  EnsemblePrediction prediction;                                ///< the band is as wide as `support` says
  BandSupport support;
  std::optional<MeasuredTest> measured = {};
};

}  // namespace lacuna
