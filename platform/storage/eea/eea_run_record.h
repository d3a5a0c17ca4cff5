#pragma once

#include "storage/core/database.h"
#include "storage/eea/eea_records.h"

#include <optional>
#include <string>

namespace lacuna {

/// In the caller's transaction.
void write_run_record(const Database& database, RunId run, ExperimentId experiment, const EeaRunRecord& record);
/// Nothing where the run is not one of the algorithm.
std::optional<EeaRunRecord> read_run_record(const Database& database, RunId run);
/// What the second has that the first has not, in words; empty: they are the same.
std::string difference(const EeaRunRecord& first, const EeaRunRecord& second);

}  // namespace lacuna
