#pragma once

#include "residual_law/force_findings.h"
#include "search/effect_search.h"

#include <vector>

namespace lacuna {

/// The force that the model as it is lacks on each joint where the answer acts, three joints at most: over position,
/// velocity, command and time, where such a curve alone gains more than its error, each with what the answer makes of
/// it. The same smooth law is fitted to the model's residuals and to those that the answer removes from them, so that
/// both are blurred alike. None where there is no answer.
std::vector<ForceCurve> missing_force(const SearchResult& found);

}  // namespace lacuna
