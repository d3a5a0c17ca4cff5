#pragma once

#include "cases/make_case.h"
#include "runs/records.h"

namespace hidden_effects {

/// What a case's data could tell with the truth known, as the database keeps it.
OracleRecord oracle_record(const MadeCase& made);

/// The effects that the oracle does not tell from a hidden law, and these laws' own: each once.
std::vector<std::string> class_effects(const CaseRecord& about, const OracleRecord& oracle);

}  // namespace hidden_effects
