#pragma once

#include "storage/database.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace lacuna {

/// NULL, integer, real, text or bytes, with their content.
using PageCell = std::variant<std::monostate, std::int64_t, double, std::string, std::vector<std::byte>>;

/// What a page asks: one statement or several that read, of which the last one's rows are the answer.
struct PageQuery {
  std::string sql;
  std::vector<PageCell> values;  ///< of the parameters of the last statement
  std::size_t most_rows = 100'000;
  std::chrono::milliseconds longest{10'000};
};

struct PageTable {
  std::vector<std::string> columns;
  std::vector<std::vector<PageCell>> rows;
  bool cut = false;  ///< there was more
};

/// Asks the database of a user together with the tables of a `PageDatabase` that is the file `pages`. A connection
/// lives for one question, so that a file that is replaced is found. The samples of traces are rows of `samples`.
/// Throws `BadInput` for faults of the SQL or where there is no such database, else `Error`, each with a sentence.
PageTable ask_for_page(const std::filesystem::path& database, const std::filesystem::path& pages,
                       const PageQuery& query);

/// Changes whenever the database does: with each commit, and when another file takes its place. Cheap; nothing is
/// opened. Empty: there is no such file.
std::string stamp_of(const std::filesystem::path& database);

}  // namespace lacuna
