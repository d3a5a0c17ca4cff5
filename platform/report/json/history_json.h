#pragma once

#include "evaluation/model/known_setups.h"
#include "storage/core/records.h"

#include <string>
#include <vector>

namespace lacuna {

/// `missing`: a sentence on errors of the current model that are not stored, `next`: the command that stores them;
/// empty: nothing is missing.
std::string history_json(const std::vector<HistoryRow>& rows, int held_out_looks, const std::string& missing = {},
                         const std::string& next = {}, const std::vector<KnownSetup>& setups = {});
std::string history_csv(const std::vector<HistoryRow>& rows);

}  // namespace lacuna
