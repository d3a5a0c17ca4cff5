#pragma once

#include "answer/find_missing_effects.h"
#include "search/effect_search.h"

namespace lacuna {

/// Proposes the test that would tell the answer from the set nearest to it on these data, or says that none was found.
/// Its readings are assumed to scatter as the answer's longest predictions do.
void propose_settling_test(const DiagnosisTask& task, const SearchResult& found, Diagnosis& result);

}  // namespace lacuna
