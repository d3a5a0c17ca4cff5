#pragma once

#include "measurement/trials/read_tables.h"

#include <string>
#include <vector>

namespace lacuna {

/// Decodes sensors and commands as the devices encoded them. Encodings that no mapping states are those that a column
/// shows in all tables together; each that is found is noted, with the line that states it. Numbers that no device
/// writes (1e-308, 1e300) are missing values.
void decode_tables(const RecordingPlan& plan, std::vector<ReadTable>& tables);

}  // namespace lacuna
