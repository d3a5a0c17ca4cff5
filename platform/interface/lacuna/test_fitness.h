#pragma once

#include <lacuna/parameter.h>
#include <lacuna/test.h>
#include <lacuna/time_series.h>

#include <Eigen/Core>

#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// What one model says a test would give.
struct TestPrediction {
  TimeSeries sensors;         ///< sample times × sensor channels
  TimeSeries centre_of_mass;  ///< of the whole robot, the same times × x, y, z; world frame, m
  /// Standard deviation of a reading, one a sensor channel, in its unit; empty: nothing is known of it.
  std::vector<double> noise = {};
  /// Derivatives of the readings by each of the model's free values, in the readings' units for a value that moves
  /// through its whole range; of no size for a value that changes nothing. Empty where the fitness asks for none.
  std::vector<TimeSeries::Samples> slopes = {};
  /// What the trials so far tell of these values, and what their ranges do: values × values, in nats (the inverse of
  /// the values' covariance, where a range is 1). Empty where `slopes` is.
  Eigen::MatrixXd information = {};
};

/// How good a test is, judged on models' predictions of it alone. Larger is better. Const and shared by threads.
class TestFitness {
 public:
  virtual ~TestFitness() = default;

  /// One sentence for `lacuna plugins`.
  virtual std::string summary() const = 0;
  virtual ParameterDeclarations parameters() const { return {}; }
  /// Of the score: SI; "1" where it has none.
  virtual std::string unit() const = 0;
  /// How many of the best models, best first, must predict the test.
  virtual std::size_t models(std::span<const double> parameters) const = 0;
  /// Whether predictions come with `slopes` and `information`, which costs a simulation for each free value.
  virtual bool wants_slopes(std::span<const double>) const { return false; }
  /// `predictions`: one a model, best first; each reaches the test's end. Not finite: the test is worth nothing.
  virtual double score(const Test& test, std::span<const TestPrediction> predictions,
                       std::span<const double> parameters) const = 0;
};

}  // namespace lacuna
