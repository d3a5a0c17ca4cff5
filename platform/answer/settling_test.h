#pragma once

#include "answer/find_missing_effects.h"
#include "search/effect_search.h"

namespace lacuna {

/// Proposes the test that would tell the answer from the set that does most nearly the same on these data, where there
/// is one, or says that none was found. Readings of it are taken to scatter as much as the answer's longest predictions
/// do.
void propose_settling_test(const DiagnosisTask& task, const SearchResult& found, Diagnosis& result);

}  // namespace lacuna
