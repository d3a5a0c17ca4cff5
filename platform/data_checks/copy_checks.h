#pragma once

#include "data_checks/data_warning.h"

#include <vector>

namespace lacuna {

/// Checks for files with the same readings under the same commands as an earlier file: noise never repeats. Held-out
/// files are compared, too, since a copy of a fit file confirms nothing.
std::vector<DataWarning> copy_checks(const std::vector<Trial>& trials);

}  // namespace lacuna
