#pragma once

#include <Eigen/Core>

namespace lacuna {

/// The prediction of a test by one candidate, in standard deviations of the readings.
struct CandidatePrediction {
  Eigen::VectorXd readings;
  /// Change of the readings by one standard deviation of each independent quantity that a refit to this test would
  /// change: directions of the model's free values and the timestamp offset given the data so far, and unknown
  /// components of the start. One column each; none: nothing is refitted.
  Eigen::MatrixXd follows;
  /// How far each of these has already moved at the prediction, in deviations; empty: not at all.
  Eigen::VectorXd moved = {};
};

/// Residual of the difference `truth` − `candidate` when the candidate is refitted, to first order, to so many
/// trials of the test and the data so far. With d the difference, F the candidate's `follows`, m how far it has moved
/// and s the step of the refit,
///
///     min over s of  trials · |d − F s|² + |m + s|²
///
/// is the squared length of the result, whose last rows are m + s: twice the log likelihood, in nats, that the trials
/// are expected to give the truth over the candidate. Without `follows` it is the difference itself.
///
/// Literature: A. C. Atkinson and V. V. Fedorov, Biometrika 62 (1975) 57-70 (T-optimality).
Eigen::VectorXd unexplained(const CandidatePrediction& truth, const CandidatePrediction& candidate,
                            double trials = 1.0);

}  // namespace lacuna
