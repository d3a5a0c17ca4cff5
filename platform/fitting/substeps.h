#pragma once

#include <lacuna/trial.h>

#include "evaluation/model/model_definition.h"
#include "fitting/integration_bias.h"

#include <span>
#include <vector>

namespace lacuna {

/// How many integration steps a model takes in a step of its engine's settings.
struct Substeps {
  int count = 1;
  /// What the integration does to a free run, as a share of what is not known of it anyway: the sensor noise, or what
  /// one standard error of the start does, whichever is larger. RMS; of the channel where it is largest.
  double share = 0.0;
  ValueShift shift;    ///< what it does to the free values; of that which it moves most
  bool enough = true;  ///< false: `share` or `shift` is too large still; more bring too little, or are not tried
};

/// What the trials are for.
enum class TrialsFor {
  fit,    ///< the free values are fitted to them: their bias counts
  motion  ///< they show how the model moves, as imagined tests do
};

/// The fewest substeps, whatever the definition has, with which free runs of `trials` are integrated well enough: two
/// solutions, one with twice as many, tell the error, for the engine is of second order. Then as many as keep the bias
/// of the free values, which a fit with `options` would find, small beside their intervals. Where more bring the
/// solutions no nearer to each other, as in a chaotic motion, no more are taken. `values`: the model's. One where the
/// model cannot be simulated; the share is infinite then. One with ode, of which contacts make another model of each
/// step. The same digits whatever the number of threads. Throws `Interrupted`, and `Error` where the trials do not fit
/// the model.
///
/// Literature: L. F. Richardson, "The deferred approach to the limit", 1927.
Substeps sufficient_substeps(const ModelDefinition& definition, const std::vector<Trial>& trials,
                             std::span<const double> values, int threads, TrialsFor trials_for = TrialsFor::fit,
                             const FitSection& options = {});

}  // namespace lacuna
