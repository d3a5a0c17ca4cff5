#pragma once

#include "cases/make_case.h"
#include "oracle/oracle.h"
#include "runs/records.h"

#include <string>
#include <vector>

namespace hidden_effects {

/// What the oracle said, as the database keeps it. Of a case that hides nothing, the widths alone.
OracleRecord oracle_record(const MadeCase& made, const OracleAnswer& answer);

/// Effects that a library without the hidden laws must not have: theirs, and those that the oracle does not tell from
/// one of them.
std::vector<std::string> class_effects(const MadeCase& made, const OracleAnswer& answer);

/// What the baselines say of the case's recorded side.
std::vector<BaselineRecord> baseline_records(const MadeCase& made, const std::vector<std::string>& withheld);

}  // namespace hidden_effects
