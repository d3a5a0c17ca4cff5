#pragma once

#include "runs/database.h"
#include "runs/records.h"

#include <string>
#include <vector>

namespace hidden_effects {

/// Makes the table of what is really there in dirty cases, `dirty_effect`, where the database does not have it.
void make_dirty_table(Database& database);

/// Writes what is really there; part of the transaction in which the rest of the case is written.
void write_dirty_effects(Database& database, const CaseRecord& about, const std::vector<DirtyEffectRecord>& effects);

/// The dirty cases of a version as they came out: plan, failure, the first diagnosis, what is really there. In the
/// order of their numbers.
std::vector<CaseResult> read_dirty_results(const Database& database, const std::string& version,
                                           const std::string& set);

}  // namespace hidden_effects
