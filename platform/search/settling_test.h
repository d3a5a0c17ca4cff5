#pragma once

#include "search/find_missing.h"

namespace lacuna {

/// Proposes the test that would tell the answer from the set that does the same on these data, where there is one, or
/// says that none was found. Readings of it are taken to scatter as much as the answer's longest predictions do.
void propose_settling_test(const DiagnosisTask& task, const Ground& ground, const Missing& missing, Diagnosis& result);

}  // namespace lacuna
