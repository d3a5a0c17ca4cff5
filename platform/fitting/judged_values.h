#pragma once

#include "fitting/shooting/refinement.h"
#include "fitting/starts/start_states.h"

#include <memory>
#include <string>
#include <vector>

namespace lacuna {

/// Values with what a fit's last stage makes of them as they are.
struct JudgedValues {
  std::string name;  ///< where they come from
  std::unique_ptr<ShootingProblem> problem;
  Candidate candidate;

  /// What the fit minimises, per sample, so that values whose starts tell other samples can be compared; infinite where
  /// the model cannot be simulated.
  double objective() const;
};

/// Judges values by a fit's last stage: the one measure by which a result is chosen, whatever searches led to it. The
/// trials' starts are told by the values themselves. Everything referred to must outlive the judge and what it judged.
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
