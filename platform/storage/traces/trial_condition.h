#pragma once

#include "storage/core/database.h"
#include "storage/core/records.h"

#include <lacuna/trial.h>

namespace lacuna {

/// Properties of a trial beside its samples: hold of the commands, knowledge of the initial state, declared noise. In
/// the caller's transaction; stored once.
void write_trial_condition(const Database& database, TrialId trial, const Trial& from);

/// A trial with its commands, what was measured and the centre of mass. Throws `Error` if that is not what its digest
/// says.
Trial read_trial(const Database& database, TrialId trial);

}  // namespace lacuna
