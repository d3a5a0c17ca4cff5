#pragma once

#include <lacuna/trial.h>

#include "evaluation/model/model_definition.h"
#include "fitting/integration_bias.h"

#include <span>
#include <vector>

namespace lacuna {

/// Number of integration steps per step of a model's engine settings.
struct Substeps {
  int count = 1;
  /// Integration error of a free run over its unavoidable uncertainty: the sensor noise, or the effect of one standard
  /// error of the initial state, whichever is larger. RMS; of the channel where it is largest.
  double share = 0.0;
  ValueShift shift;    ///< change of the free values; of the one that changes most
  bool enough = true;  ///< false: `share` or `shift` is too large still, but more substeps improve it too little, or
                       ///< are not tried
};

/// The use of the trials.
enum class TrialsFor {
  fit,    ///< the free values are fitted to them: their bias matters
  motion  ///< they only show the motion of the model, as imagined tests do
};

/// The smallest number of substeps, whatever the definition has, with which free runs of `trials` are integrated well
/// enough: the error follows from two solutions, one with twice as many, because the engine is of second order. Then as
/// many as keep the bias of the free values, which a fit with `options` would find, small compared with their
/// intervals. Where more substeps do not bring the solutions closer, as in a chaotic motion, no more are used.
/// `values`: the model's. One substep, with an infinite share, where the model cannot be simulated. One with ode,
/// because its contacts are another model for each step. The same digits for any number of threads. Throws
/// `Interrupted`, and `Error` where the trials do not fit the model.
///
/// Literature: L. F. Richardson, "The deferred approach to the limit", 1927.
Substeps sufficient_substeps(const ModelDefinition& definition, const std::vector<Trial>& trials,
                             std::span<const double> values, const Work& work, TrialsFor trials_for = TrialsFor::fit,
                             const FitSection& options = {});

}  // namespace lacuna
