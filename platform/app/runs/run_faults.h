#pragma once

#include "storage/core/database.h"

#include <string>
#include <vector>

namespace lacuna {

/// What keeps runs of a database from being gone on with, replayed and reproduced, as far as it shows without their
/// experiments' plugins: everything that these commands read of a run is read by their own functions. So are trials
/// that were carried out one by one. A sentence for each at fault. Throws `Interrupted`.
std::vector<std::string> faults_of_runs(Database& database);

}  // namespace lacuna
