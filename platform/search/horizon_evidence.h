#pragma once

#include "diagnosis/findings/diagnosis.h"
#include "search/find_missing.h"

namespace lacuna {

/// What a search shows of how sure its answer is, each figure by name and within a range
/// (diagnosis/verdict/calibration.h). `horizons`: of the answer.
Evidence evidence_of(const Missing& missing, const std::vector<HorizonError>& horizons);

}  // namespace lacuna
