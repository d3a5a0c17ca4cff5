#pragma once

#include "evaluation/model/known_setups.h"
#include "storage/core/records.h"

#include <string>
#include <vector>

namespace lacuna {

/// Error by revision: a table a channel, with a bar for the multiple of the floor.
/// `held_out_looks`: how often held-out data were looked at so far.
/// `setups`: of the recordings, listed at the end.
std::string history_text(const std::vector<HistoryRow>& rows, int held_out_looks,
                         const std::vector<KnownSetup>& setups = {});

}  // namespace lacuna
