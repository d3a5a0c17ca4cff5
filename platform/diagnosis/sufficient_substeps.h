#pragma once

#include "diagnosis/base_solution.h"
#include "evaluation/model_definition.h"

namespace lacuna {

/// The fewest substeps, up to the definition's own, that predict the base's segments to twice the sensor noise (RMS
/// change by twice as many). Segments are short: they need fewer than a long free run, which keeps the definition's.
int sufficient_substeps(const ModelDefinition& definition, const BaseSolution& base, int threads);

}  // namespace lacuna
