#pragma once

#include <Eigen/Core>

namespace lacuna {

/// What a model says about a test, in standard deviations of the readings.
struct RivalPrediction {
  Eigen::VectorXd readings;
  /// How the readings change by one standard deviation of each thing that a refit to this test would find anew, which
  /// are independent of each other: directions of the model's free values and of the instant that commands act at, as
  /// the data so far leave them, unknown parts of the start. A column each; none: nothing is refitted.
  Eigen::MatrixXd follows;
  /// How far all that is off already where the readings are predicted, in deviations; empty: not at all.
  Eigen::VectorXd moved = {};
};

/// What is left of the difference `truth` − `rival` when the rival is refitted, to first order, to so many trials of
/// the test and the data so far. With d the difference, F the rival's `follows`, m how far it has moved and s the step
/// of the refit,
///
///     min over s of  trials · |d − F s|² + |m + s|²
///
/// is the squared length of the result, whose last rows are m + s: twice the log likelihood, in nats, that the trials
/// are expected to give the truth over the rival. Without `follows` it is the difference itself.
///
/// Literature: A. C. Atkinson and V. V. Fedorov, Biometrika 62 (1975) 57-70 (T-optimality).
Eigen::VectorXd unexplained(const RivalPrediction& truth, const RivalPrediction& rival, double trials = 1.0);

}  // namespace lacuna
