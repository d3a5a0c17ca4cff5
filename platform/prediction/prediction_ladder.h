#pragma once

#include "criterion/block_products.h"
#include "fitting/floor/noise_floor.h"
#include "prediction/smoothed_starts.h"

#include <Eigen/Core>

#include <vector>

namespace lacuna {

/// A stretch that is predicted from a start which the readings tell. Its first sample is the start.
struct PredictedStretch {
  Stretch stretch;
  std::size_t length = 0;                   ///< which of the ladder's lengths
  StartState start;                         ///< as smoothed
  std::vector<int> unknown;                 ///< components of the start that readings tell
  Eigen::MatrixXd covariance;               ///< of these, SI
  std::vector<Eigen::Index> rows, columns;  ///< readings that count: row in the stretch, channel of the trial
  std::vector<std::size_t> channels;        ///< by reading: index into the ladder's noise
  std::vector<std::size_t> blocks;          ///< by reading: of time
};

/// Stretches of several lengths, each tiling the trials that are fitted (or held out), from starts that favour no
/// candidate model.
struct PredictionLadder {
  std::vector<double> lengths;              ///< s, ascending
  std::vector<PredictedStretch> stretches;  ///< by length
  std::vector<ChannelNoise> noise;          ///< standard deviations of readings, by channel
  CellLayout layout;                        ///< cells: length by length, a cell a channel

  std::size_t cell(std::size_t length, std::size_t channel) const { return length * noise.size() + channel; }
};

/// What a ladder is built from.
struct LadderSource {
  const RobotSpec& robot;
  const TrialPredictor& predictor;
  const StartStates& states;
  const SmoothedStarts& starts;
  const std::vector<ChannelNoise>& noise;
  bool held_out = false;  ///< of what is held out, else of the rest
};

/// Of these lengths, s. Forty blocks of time; folds are the recordings, or thirds of time where there are fewer than
/// three. All joints weigh the same, and channels of one joint share its weight. `most`: stretches of a length, evenly
/// spread.
PredictionLadder ladder_of(const LadderSource& source, std::vector<double> lengths, std::size_t most);

/// By channel, the element that its sensor reads.
std::vector<std::string> joints_of(const RobotSpec& robot, const std::vector<ChannelNoise>& noise);

/// The first `count` lengths alone.
PredictionLadder shorter(const PredictionLadder& ladder, std::size_t count);

double root_of_channels(const std::vector<ChannelNoise>& noise);

/// Of each length as many stretches, evenly spread, as have these samples together, over the root of the number of
/// channels, since each sample has a reading of every one; at least two.
PredictionLadder thinned(const PredictionLadder& ladder, std::size_t samples);

}  // namespace lacuna
