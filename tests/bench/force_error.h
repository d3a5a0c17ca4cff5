#pragma once

#include "evaluation/prediction/trial_predictor.h"

#include <span>

namespace lacuna {

/// What force a model gets wrong at each moment, rather than where it drifts to.
struct ForceError {
  double rms = 0.0;       ///< N or N·m, of the force that would make good what the model's acceleration lacks
  double relative = 0.0;  ///< over the RMS of the command
};

/// Of a trial of a robot with one joint, whose first measured channel is its position and whose only command is a
/// force. Position and command are low-passed without phase (zero_phase.h); from the filtered state of each sample the
/// model is simulated to the next one under the filtered command, and its acceleration held against the filtered one's.
/// Accelerations become forces by the command that would change them as much. The first and last 0.2 s are left out.
ForceError force_error(const CompiledModel& model, const Trial& trial, std::span<const double> values, double cutoff);

}  // namespace lacuna
