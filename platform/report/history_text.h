#pragma once

#include "evaluation/known_setups.h"
#include "storage/records.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

/// Error by revision: a table a channel, with a bar for the multiple of the floor.
/// `held_out_looks`: how often held-out data were looked at so far.
/// `setups`: of the recordings, listed at the end.
std::string history_text(const std::vector<HistoryRow>& rows, int held_out_looks,
                         const std::vector<KnownSetup>& setups = {});
/// `missing`: a sentence on errors of the current model that are not stored, `next`: the command that stores them;
/// empty: nothing is missing.
std::string history_json(const std::vector<HistoryRow>& rows, int held_out_looks, const std::string& missing = {},
                         const std::string& next = {}, const std::vector<KnownSetup>& setups = {});
std::string history_csv(const std::vector<HistoryRow>& rows);

/// One SVG a channel, `history-<channel>.svg`: fit and held-out error by revision, and the floor.
std::vector<std::filesystem::path> draw_history(const std::vector<HistoryRow>& rows, const std::string& title,
                                                const std::filesystem::path& folder);

}  // namespace lacuna
