#pragma once

#include <lacuna/parameter.h>
#include <lacuna/test.h>
#include <lacuna/time_series.h>

#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// What one model says a test would give.
struct TestPrediction {
  TimeSeries sensors;         ///< sample times × sensor channels
  TimeSeries centre_of_mass;  ///< of the whole robot, the same times × x, y, z; world frame, m
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
  /// `predictions`: one a model, best first; each reaches the test's end. Not finite: the test is worth nothing.
  virtual double score(const Test& test, std::span<const TestPrediction> predictions,
                       std::span<const double> parameters) const = 0;
};

}  // namespace lacuna
