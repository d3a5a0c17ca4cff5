#pragma once

#include "diagnosis/findings/diagnosis.h"

namespace lacuna {

/// METHOD's search, effect by effect, in data that allow one: throws `Error` where the trials do not fit the model, and
/// `Interrupted`.
Diagnosis search_effects(const DiagnosisTask& task);

}  // namespace lacuna
