#pragma once

#include "storage/eea/eea_store.h"

#include <vector>

namespace lacuna {

/// The newest of the runs and the other replicates of its setting: what a mean may be taken over, by replicate. Of a
/// replicate that was run several times, the newest. `runs` has at least one, by number.
std::vector<EeaRunListing> newest_setting(const Database& database, const std::vector<EeaRunListing>& runs);

}  // namespace lacuna
