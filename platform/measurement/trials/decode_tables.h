#pragma once

#include "measurement/trials/read_tables.h"

#include <string>
#include <vector>

namespace lacuna {

/// Sensors and commands as the devices meant them. Encodings that no mapping states are those that a column shows in
/// all tables together; each that is found is noted, with the line that states it. Numbers that a device never wrote
/// (1e-308, 1e300) are missing.
void decode_tables(const RecordingPlan& plan, std::vector<ReadTable>& tables);

}  // namespace lacuna
