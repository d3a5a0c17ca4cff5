#pragma once

#include "diagnosis/diagnosis.h"

namespace lacuna {

/// METHOD: what effects, if any, the model lacks. Where its predictions are far from what noise allows they are what
/// sets of effects are judged by, over a ladder of horizons; doubts about the data stand beside the verdict then. Where
/// they are near, likelihoods are (`diagnose`). Where the time limit is reached (foundation/interrupt.h), it is lifted
/// and the diagnosis is `stopped`. Throws `Error` where the trials do not fit the model, and `Interrupted`.
Diagnosis find_missing_effects(const DiagnosisTask& task);

}  // namespace lacuna
