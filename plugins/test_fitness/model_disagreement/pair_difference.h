#pragma once

#include <lacuna/test_fitness.h>

#include <span>

namespace lacuna {

/// The difference between the readings of two models in one test, in standard deviations of the noise.
class PairDifference {
 public:
  /// `noise`: standard deviation of a reading of each channel, in its unit. Throws `Error` where the predictions differ
  /// in their shape.
  PairDifference(const TestPrediction& one, const TestPrediction& other, std::span<const double> noise);

  /// Sum of its squares.
  double squared() const { return difference_.squaredNorm(); }
  /// The same after the wrong model has changed its values to match the other's readings, as far as the information on
  /// these values allows, to first order; the mean over which one is wrong. Throws `Error` without slopes.
  double squared_after_refit() const { return 0.5 * (left_by(one_) + left_by(other_)); }

 private:
  double left_by(const TestPrediction& wrong) const;
  Eigen::VectorXd in_deviations(const TimeSeries::Samples& readings) const;

  const TestPrediction& one_;
  const TestPrediction& other_;
  Eigen::VectorXd inverse_noise_;  ///< one a channel
  Eigen::VectorXd difference_;     ///< samples × channels, row after row
};

}  // namespace lacuna
