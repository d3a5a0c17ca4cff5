#pragma once

#include "fitting/segments.h"
#include "horizons/smoothed_starts.h"

#include <string>
#include <vector>

namespace lacuna {

/// Predictions over one length, from starts that the data tell.
struct Rung {
  double length = 0.0;              ///< s
  std::vector<Segment> segments;    ///< of all trials asked for, which they tile
  std::vector<double> floor;        ///< by channel: variance of a residual that a right model has, channel unit squared
  std::vector<double> start_share;  ///< by channel: what of it the starts' uncertainty makes
  std::vector<double> motion;       ///< by channel: mean square of a reading's way from the segment's start
  std::vector<bool> counts;         ///< by channel: the motion stands out of the floor
  std::vector<double> weight;       ///< by channel, 0 where it does not count; of all rungs they sum to 1
};

/// Lengths over which a model's predictions are compared with the data: four or five, geometric, from some ten samples
/// to whole trials, or as far as the starts' uncertainty lets a prediction mean something. The same for all candidates.
struct Ladder {
  std::vector<Rung> rungs;
  std::vector<ChannelNoise> channels;
  bool ended_by_starts = false;  ///< longer predictions than the last rung's would tell of their starts alone
};

/// What a ladder is built from.
struct LadderTask {
  const RobotSpec& robot;
  const TrialPredictor& predictor;
  const StartStates& states;
  const SmoothedStarts& starts;
  const std::vector<ChannelNoise>& noise;
  const std::vector<double>& values;  ///< of the model with which the starts' share is computed
  bool held_out = false;              ///< of the trials that are kept from the fit
};

/// Of the trials to fit to.
Ladder build_ladder(const LadderTask& task);

/// The same lengths, floors and weights with segments of other trials, or for another model of the same robot.
Ladder same_ladder(const Ladder& ladder, const LadderTask& task);

/// About this share of each rung's segments, evenly spread, but `least` of each if it has them. For a first look.
Ladder thinned(const Ladder& ladder, double share, std::size_t least);
/// What a first look needs: few segments, without the rung of the longest.
Ladder quick(const Ladder& ladder);
/// The shorter rungs alone.
Ladder first_rungs(const Ladder& ladder, std::size_t count);

std::vector<Segment> all_segments(const Ladder& ladder);

/// Which of the ladder's channels a column of a trial's readings is.
std::size_t channel_index(const Ladder& ladder, const Trial& trial, Eigen::Index column);

}  // namespace lacuna
