#pragma once

#include "diagnosis/base_solution.h"
#include "evaluation/model_definition.h"

namespace lacuna {

/// Takes the integrator's error off the measurements that the segments hold: what infinitely short steps would predict
/// at the base's values and states, less what `definition` predicts with the steps that it has. So a model with few
/// substeps fits and tests as one with many would; a thousandth of the sensor noise in every sample would otherwise
/// pass for a small delay. Commands act as recorded: when they do changes that error by little. False, and nothing is
/// changed, where the model cannot be simulated, and of free runs, whose errors grow past first order (contact_doubt.h
/// widens their noise instead).
///
/// Literature: L. F. Richardson, "The deferred approach to the limit", 1927.
bool correct_for_steps(const ModelDefinition& definition, BaseSolution& base, int threads);

}  // namespace lacuna
