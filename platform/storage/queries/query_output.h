#pragma once

#include "storage/core/reading_only.h"
#include "storage/queries/query.h"

#include <cstddef>
#include <memory>
#include <ostream>
#include <string>

namespace lacuna {

enum class QueryFormat {
  table,      ///< aligned columns, six significant digits, numbers to the right, NULL as nothing
  csv,        ///< RFC 4180 with a header line; every digit
  json,       ///< a list of objects for each statement; every digit; what is not finite is null
  json_lines  ///< an object a line
};

/// A cell as text: every digit of a number, nothing for NULL, "(5 bytes)" for bytes.
std::string cell_text(const Cell& cell);

/// Writes to `stream`, which outlives it. CSV and JSON are written as rows come. A table is kept until its columns'
/// widths are known: one that takes more than `most_bytes` is refused with `BadInput`.
std::unique_ptr<QueryOutput> make_query_output(QueryFormat format, std::ostream& stream,
                                               std::size_t most_bytes = ReadingOnly::kMostQueryMemory);

}  // namespace lacuna
