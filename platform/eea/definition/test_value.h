#pragma once

#include <lacuna/test_fitness.h>

#include "evaluation/model/component_choice.h"

#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// What a test is worth: one fitness, or the weighted sum of several, such as disagreement and a desired behaviour.
/// Const and shared by threads.
class TestValue {
 public:
  struct Part {
    Chosen<TestFitness> fitness;
    double weight = 1.0;  ///< in the first part's unit by the part's own
  };

  TestValue() = default;
  /// At least one part. Throws what a part's plugin throws, named.
  explicit TestValue(std::vector<Part> parts);

  std::string name() const;  ///< "model_disagreement", "model_disagreement + 0.5 forward_distance"
  std::string unit() const;  ///< of the first part
  /// How many models must predict a test: the most that a part asks for.
  std::size_t models() const { return models_; }
  bool wants_slopes() const { return wants_slopes_; }
  /// Whether it compares models, or holds them against noise, of which nothing is known before the first trial.
  bool takes_trials() const { return models_ > 1 || wants_slopes_; }
  /// `predictions`: `models()` of them.
  double score(const Test& test, std::span<const TestPrediction> predictions) const;
  /// Which fitness gave a score that is not finite, a sentence; empty where none did.
  std::string why_not_finite(const Test& test, std::span<const TestPrediction> predictions) const;

 private:
  double score_of_part(std::size_t part, const Test& test, std::span<const TestPrediction> predictions) const;

  std::vector<Part> parts_;
  std::vector<std::size_t> models_of_part_;
  std::size_t models_ = 0;
  bool wants_slopes_ = false;
};

}  // namespace lacuna
