#pragma once

#include "foundation/processes/stop.h"
#include "storage/queries/query.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace lacuna {

/// NULL, integer, real, text, bytes with their content, or how many they are.
using PageCell = std::variant<std::monostate, std::int64_t, double, std::string, std::vector<std::byte>, Blob>;

/// A query of a page may take as long.
inline constexpr std::chrono::milliseconds kLongestPageQuery{10'000};

/// The query of a page: one or more reading statements; the rows of the last one are the answer.
struct PageQuery {
  std::string sql;
  std::vector<PageCell> values = {};  ///< of the parameters of the last statement
  std::size_t most_rows = 100'000;
  std::size_t most_bytes = 64U << 20U;  ///< after which no further row is taken
  bool sizes = false;                   ///< of bytes their number is enough, as where a user typed the question
  std::chrono::milliseconds longest = kLongestPageQuery;
};

struct PageTable {
  std::vector<std::string> columns;
  std::vector<std::vector<PageCell>> rows;
  bool cut = false;  ///< there was more
};

/// Asks the database of a user together with the tables of a `PageDatabase` that is the file `pages`. A connection
/// lives for one question, so that a file that is replaced is found. The samples of traces are rows of `samples`.
/// Throws as `run_queries` does, and `BadInput` where there is no such database or the query takes too long.
PageTable ask_for_page(const std::filesystem::path& database, const std::filesystem::path& pages,
                       const PageQuery& query, const Stop& stop = {});

/// Changes whenever the database does: with each commit, and when another file takes its place. Cheap; nothing is
/// opened. Empty: there is no such file.
std::string stamp_of(const std::filesystem::path& database);

}  // namespace lacuna
