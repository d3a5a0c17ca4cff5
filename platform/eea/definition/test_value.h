#pragma once

#include <lacuna/test_fitness.h>

#include "evaluation/model/component_choice.h"

#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// The worth of a test: one fitness, or the weighted sum of several, such as disagreement and a desired behaviour.
/// Const and shared by threads.
class TestValue {
 public:
  struct Part {
    Chosen<TestFitness> fitness;
    double weight = 1.0;  ///< the first part's unit over this part's unit
  };

  TestValue() = default;
  /// At least one part. Throws a part's error with the name of its plugin.
  explicit TestValue(std::vector<Part> parts);

  std::string name() const;  ///< "model_disagreement", "model_disagreement + 0.5 forward_distance"
  std::string unit() const;  ///< of the first part
  /// How many models must predict a test: the most that any part needs.
  std::size_t models() const { return models_; }
  bool wants_slopes() const { return wants_slopes_; }
  /// Whether it compares models, or compares them with noise, which is unknown before the first trial.
  bool takes_trials() const { return models_ > 1 || wants_slopes_; }
  /// `predictions`: `models()` of them.
  double score(const Test& test, std::span<const TestPrediction> predictions) const;
  /// Names the fitness whose score is not finite, a sentence; empty where all are finite.
  std::string why_not_finite(const Test& test, std::span<const TestPrediction> predictions) const;

 private:
  double score_of_part(std::size_t part, const Test& test, std::span<const TestPrediction> predictions) const;

  std::vector<Part> parts_;
  std::vector<std::size_t> models_of_part_;
  std::size_t models_ = 0;
  bool wants_slopes_ = false;
};

}  // namespace lacuna
