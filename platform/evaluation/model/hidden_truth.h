#pragma once

#include "evaluation/model/model_definition.h"

#include <cstdint>
#include <vector>

namespace lacuna {

/// Draws what a simulated target hides, uniformly and each value by itself: one a `target.free`, in that order. The
/// same seed gives the same values; with `redraw` each replicate (from 1) has its own.
std::vector<double> draw_hidden_values(const ModelDefinition& target, const SimulatedSource& source, int replicate);

/// What the target has for each free value of the model: the hidden value, or the robot's or effect's own, or NaN where
/// the target has no such value.
std::vector<double> true_values(const ModelDefinition& model, const ModelDefinition& target,
                                const std::vector<double>& hidden);

}  // namespace lacuna
