#pragma once

#include "measurement/read_tables.h"

#include <string>
#include <vector>

namespace lacuna {

/// Time stamps that start again go on; without a statement where they clearly do.
void decode_clock(Encoding encoding, const std::string& time_column, ReadTable& read);

/// Sensors and commands as the devices meant them. Encodings that no mapping states are those that a column shows in
/// all tables together; each that is found is noted, with the line that states it. Numbers that a device never wrote
/// (1e-308) are missing.
void decode_tables(const RecordingPlan& plan, std::vector<ReadTable>& tables);

}  // namespace lacuna
