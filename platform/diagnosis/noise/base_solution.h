#pragma once

#include "diagnosis/noise/linear_segments.h"

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// A fitted model that something may be missing from: where it stands, segment by segment.
struct BaseSolution {
  std::vector<Trial> trials;        ///< those fitted to
  std::vector<ChannelNoise> noise;  ///< sensor noise; its deviations are what residuals are divided by
  std::vector<Segment> segments;
  double segment = 0.0;                 ///< s, how long the longest of them is, without what runs in
  std::vector<double> values;           ///< of the model's free values, SI
  std::vector<Eigen::VectorXd> states;  ///< of the segments' unknown starts
  std::vector<LinearSegment> linear;    ///< at these values and states
  std::vector<double> steps;            ///< of differences: of the values, then of the components of a start state
  double residual = 0.0;                ///< RMS, multiples of the sensor noise
  /// By how many command intervals commands act later than recorded, fitted beside the values (timing.h). Nothing where
  /// that is not fitted: nothing is commanded, or the data do not tell it beside the values.
  std::optional<double> timing;
  std::vector<Eigen::VectorXd> by_timing;  ///< by segment: how the residual changes with it

  /// Whether the segments are blocks of free runs (free_run.h), all of a trial from one start; else each has a start of
  /// its own.
  bool free_run = false;
  std::vector<double> bin_widths;  ///< s, least ones, by channel of `noise`; empty: as RowBins has them
  /// By segment, bins × any number: what a right model's prediction may be wrong by (contact_doubt.h), multiples of the
  /// sensor noise. Empty: nothing.
  std::vector<Eigen::MatrixXd> doubts;
  std::vector<std::string> remarks;  ///< sentences on how the trials were cut
};

}  // namespace lacuna
