#pragma once

#include "diagnosis/findings/diagnosis.h"

namespace lacuna {

/// What effect, if any, the model lacks. Data that allow no verdict (data_doubts.h) get `cannot_tell` with the
/// reasons as findings, and nothing is searched: no base, no hypotheses. Where the time limit is reached
/// (foundation/interrupt.h), it is lifted and the diagnosis is `stopped`: with what is known so far. Throws `Error`
/// where the trials do not fit the model, and `Interrupted`.
Diagnosis diagnose(const DiagnosisTask& task);

}  // namespace lacuna
