#pragma once

#include "data_checks/doubt.h"

#include <vector>

namespace lacuna {

/// Checks for files with the same readings under the same commands as an earlier file: noise never repeats. Held-out
/// files are compared, too, since a copy of a fit file confirms nothing.
std::vector<Doubt> copy_doubts(const std::vector<Trial>& trials);

}  // namespace lacuna
