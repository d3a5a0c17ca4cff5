#pragma once

#include "foundation/processes/stop.h"
#include "storage/core/records.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

/// One SVG a channel, `history-<channel>.svg`: fit and held-out error by revision, and the floor.
std::vector<std::filesystem::path> draw_history(const std::vector<HistoryRow>& rows, const std::string& title,
                                                const std::filesystem::path& folder, const Stop& stop = {});

}  // namespace lacuna
