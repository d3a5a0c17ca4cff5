#pragma once

#include "cases/make_case.h"
#include "runs/records.h"

namespace hidden_effects {

/// What a case's data could tell with the truth known, as the database keeps it. The members of the answers in `told`
/// are also looked for where the program found them, so that none counts as told apart because the oracle's own search
/// passed it by.
OracleRecord oracle_record(const MadeCase& made, const std::vector<DiagnosisRecord>& told);

/// The effects that the oracle does not tell from a hidden law, and these laws' own: each once.
std::vector<std::string> class_effects(const CaseRecord& about, const OracleRecord& oracle);

}  // namespace hidden_effects
