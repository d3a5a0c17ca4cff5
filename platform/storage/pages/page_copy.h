#pragma once

#include "storage/core/database.h"

#include <cstddef>
#include <string>
#include <vector>

namespace lacuna {

/// Copies tables with their rows, then indices and views, into a database that has none of these names, but the states
/// of checkpoints and the folders of files. Returns sentences about what was left out to stay under `most_bytes`; of
/// which runs models were left out stands in `page_run` then. For page_database.h alone.
std::vector<std::string> copy_for_pages(const Database& from, Database& to, std::size_t most_bytes);

}  // namespace lacuna
