#pragma once

#include "criterion/block_products.h"
#include "fitting/floor/noise_floor.h"
#include "prediction/smoothed_starts.h"

#include <Eigen/Core>

#include <vector>

namespace lacuna {

/// A predicted stretch. Its first sample is the start, which the readings determine.
struct PredictedStretch {
  Stretch stretch;
  std::size_t length = 0;                   ///< which of the ladder's lengths
  StartState start;                         ///< as smoothed
  std::vector<int> unknown;                 ///< components of the start that the readings determine
  Eigen::MatrixXd covariance;               ///< of these, SI
  std::vector<Eigen::Index> rows, columns;  ///< readings that count: row in the stretch, channel of the trial
  std::vector<std::size_t> channels;        ///< by reading: index into the ladder's noise
  std::vector<std::size_t> blocks;          ///< by reading: block of time
};

/// Stretches of several lengths, each length tiling the fit trials (or the held-out trials), from initial states that
/// do not depend on a candidate model.
struct PredictionLadder {
  std::vector<double> lengths;              ///< s, ascending
  std::vector<PredictedStretch> stretches;  ///< by length
  std::vector<ChannelNoise> noise;          ///< standard deviations of readings, by channel
  CellLayout layout;                        ///< cells: length by length, a cell a channel

  std::size_t cell(std::size_t length, std::size_t channel) const { return length * noise.size() + channel; }
};

/// The input of a ladder.
struct LadderSource {
  const RobotSpec& robot;
  const TrialPredictor& predictor;
  const StartStates& states;
  const SmoothedStarts& starts;
  const std::vector<ChannelNoise>& noise;
  bool held_out = false;  ///< of the held-out trials, else of the others
};

/// Stretches of these lengths, s. Forty blocks of time; folds are the recordings, or thirds of time where there are
/// fewer than three. All joints weigh the same, and channels of one joint share its weight. `most`: stretches per
/// length, evenly spread.
PredictionLadder ladder_of(const LadderSource& source, std::vector<double> lengths, std::size_t most);

/// One length, whose stretches are pairs of samples: the `pairs` of a trial follow each other, begin at every
/// `stride`-th sample of the trial of the source and are `length` s long. Their starts are exact.
PredictionLadder ladder_of_pairs(const LadderSource& source, const std::vector<Trial>& pairs, Eigen::Index stride,
                                 double length);

/// By channel, the element of its sensor.
std::vector<std::string> joints_of(const RobotSpec& robot, const std::vector<ChannelNoise>& noise);

/// The first `count` lengths alone.
PredictionLadder shorter(const PredictionLadder& ladder, std::size_t count);

double root_of_channels(const std::vector<ChannelNoise>& noise);

/// Of each length as many evenly spread stretches as have this number of samples together, over the root of the number
/// of channels, since each sample has a reading of every channel; at least two.
PredictionLadder thinned(const PredictionLadder& ladder, std::size_t samples);

}  // namespace lacuna
