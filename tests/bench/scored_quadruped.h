#pragma once

#include "evaluation/scoring/model_scorer.h"

#include <memory>
#include <vector>

namespace lacuna {

/// The same quadruped as an estimation phase sees it: its masses come anew with each evaluation, and each sample is
/// held against a measured trial.
class ScoredQuadruped {
 public:
  ScoredQuadruped();

  /// Scores a trial of `steps` steps.
  void run(int steps);

 private:
  std::unique_ptr<CompiledModel> model_;
  std::vector<double> masses_;
  int steps_ = 0;
  std::unique_ptr<ModelScorer> scorer_;
  ModelScore score_;
};

}  // namespace lacuna
