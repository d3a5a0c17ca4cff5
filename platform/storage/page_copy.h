#pragma once

#include <cstddef>
#include <string>
#include <vector>

struct sqlite3;

namespace lacuna {

/// Copies tables with their rows, then indices and views, from one connection to another that has none of these names.
/// Returns sentences about what was left out to stay under `most_bytes`. For page_database.h alone.
std::vector<std::string> copy_for_pages(sqlite3* from, sqlite3* to, std::size_t most_bytes);

}  // namespace lacuna
