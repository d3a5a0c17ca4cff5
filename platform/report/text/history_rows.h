#pragma once

#include "storage/core/records.h"

#include <string>
#include <vector>

namespace lacuna {

/// Each once, in the order of the rows.
std::vector<std::string> channels_of(const std::vector<HistoryRow>& rows);
/// Those of a channel, and those of revisions that were never compared.
std::vector<HistoryRow> rows_of(const std::vector<HistoryRow>& rows, const std::string& channel);

}  // namespace lacuna
