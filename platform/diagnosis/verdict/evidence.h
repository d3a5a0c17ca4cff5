#pragma once

#include "diagnosis/findings/diagnosis.h"

namespace lacuna {

/// What a diagnosis shows of how sure its verdict is, each figure by name and within a range: what probabilities are
/// told from (calibration.h). `steady`: the answer's effects survive other lengths of segments.
Evidence evidence_of(const Diagnosis& diagnosis, bool steady);

}  // namespace lacuna
