#pragma once

#include "fitting/shooting/refinement.h"
#include "fitting/starts/start_states.h"

#include <memory>
#include <string>
#include <vector>

namespace lacuna {

/// Values with their evaluation by a fit's last stage.
struct JudgedValues {
  std::string name;  ///< origin of the values
  std::unique_ptr<ShootingProblem> problem;
  Candidate candidate;

  /// The objective of the fit, per sample, so that values with different scored samples can be compared; infinite where
  /// the model cannot be simulated.
  double objective() const;
};

/// Evaluates values by a fit's last stage: the one measure by which a result is chosen, whatever searches led to it.
/// The trials' initial states are estimated with the values. Everything that it refers to must outlive the evaluator
/// and its results.
struct ValueJudge {
  const TrialPredictor& predictor;
  const StartStates& states;
  const ParameterSpace& space;
  const std::vector<ChannelNoise>& noise;
  double length = 0.0;           ///< s, of the last stage's segments; 0: whole trials
  const ShootingProblem& stage;  ///< the last stage's problem: its difference steps, and how many segments
  RefinementOptions options;

  JudgedValues judge(std::string name, const std::vector<double>& values) const;
};

}  // namespace lacuna
