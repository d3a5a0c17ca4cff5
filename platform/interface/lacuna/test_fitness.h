#pragma once

#include <lacuna/parameter.h>
#include <lacuna/test.h>
#include <lacuna/time_series.h>

#include <Eigen/Core>

#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// One model's prediction of a test.
struct TestPrediction {
  TimeSeries sensors;         ///< sample times × sensor channels
  TimeSeries centre_of_mass;  ///< centre of mass of the whole robot, the same times × x, y, z; world frame, m
  /// Standard deviation of a reading, one per sensor channel, in its unit; empty: unknown.
  std::vector<double> noise = {};
  /// Derivatives of the readings by each of the model's free values, in the readings' units per whole range of the
  /// value; of size zero for a value without influence. Empty where the fitness asks for none.
  std::vector<TimeSeries::Samples> slopes = {};
  /// Information of the trials so far on these values, plus that of their ranges: values × values, in nats (the inverse
  /// of the values' covariance, where a range is 1). Empty where `slopes` is.
  Eigen::MatrixXd information = {};
};

/// The worth of a test, computed only from models' predictions of it. Larger is better. Const and shared by threads.
class TestFitness {
 public:
  virtual ~TestFitness() = default;

  /// One sentence for `lacuna plugins`.
  virtual std::string summary() const = 0;
  virtual ParameterDeclarations parameters() const { return {}; }
  /// Unit of the score: SI; "1" for none.
  virtual std::string unit() const = 0;
  /// How many of the best models, best first, must predict the test.
  virtual std::size_t models(std::span<const double> parameters) const = 0;
  /// Whether predictions need `slopes` and `information`, which costs one simulation per free value.
  virtual bool wants_slopes(std::span<const double>) const { return false; }
  /// `predictions`: one per model, best first; each reaches the test's end. A result that is not finite: the test is
  /// worth nothing.
  virtual double score(const Test& test, std::span<const TestPrediction> predictions,
                       std::span<const double> parameters) const = 0;
};

}  // namespace lacuna
