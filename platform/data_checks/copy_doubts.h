#pragma once

#include "data_checks/doubt.h"

#include <vector>

namespace lacuna {

/// Of files that hold the same readings under the same commands as one before: noise never does that twice. Held-out
/// ones are compared, too, since a copy of a fit file confirms nothing.
std::vector<Doubt> copy_doubts(const std::vector<Trial>& trials);

}  // namespace lacuna
