#pragma once

#include "evaluation/model/model_definition.h"

#include <cstdint>
#include <vector>

namespace lacuna {

/// Draws the hidden values of a simulated target, uniformly and independently: one per `target.free`, in that order.
/// The same seed gives the same values; with `redraw` each replicate (from 1) has its own.
std::vector<double> draw_hidden_values(const ModelDefinition& target, const SimulatedSource& source, int replicate);

/// The target's value for each free value of the model: the hidden one, or that of its robot or effect, or NaN where
/// the target has no such value.
std::vector<double> true_values(const ModelDefinition& model, const ModelDefinition& target,
                                const std::vector<double>& hidden);

}  // namespace lacuna
