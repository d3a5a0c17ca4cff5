#pragma once

#include "diagnosis/diagnosis.h"

namespace lacuna {

/// METHOD: what effects, if any, the model lacks, by the errors of its predictions over a ladder of horizons. Doubts
/// about the data stand beside the verdict. Where nothing can be predicted from any start, the verdict is
/// `cannot_tell`. Where the time limit is reached (foundation/interrupt.h), it is lifted and the diagnosis is
/// `stopped`. Throws `Error` where the trials do not fit the model, and `Interrupted`.
Diagnosis diagnose_by_horizon(const DiagnosisTask& task);

}  // namespace lacuna
