#pragma once

#include "residual_law/force_findings.h"
#include "search/effect_search.h"

#include <vector>

namespace lacuna {

/// The force that the model as it is lacks on each joint where the answer acts, on at most three joints: over position,
/// velocity, command and time, where such a curve alone gains more than its error, each with the part that the answer
/// explains. The same smooth law is fitted to the model's residuals and to the part of them that the answer removes, so
/// that both are smoothed alike. None where there is no answer.
std::vector<ForceCurve> missing_force(const SearchResult& found);

}  // namespace lacuna
