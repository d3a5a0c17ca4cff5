#pragma once

#include "storage/core/database.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

struct sqlite3_stmt;

namespace lacuna {

class ReadingOnly;

struct Blob {
  std::size_t bytes = 0;  ///< its content is not for reading
  bool operator==(const Blob&) const = default;
};

/// NULL, integer, real, text or bytes.
using Cell = std::variant<std::monostate, std::int64_t, double, std::string, Blob>;

/// Takes what queries find, statement by statement.
class QueryOutput {
 public:
  virtual ~QueryOutput() = default;
  virtual void begin(const std::vector<std::string>& columns) = 0;
  virtual void row(const std::vector<Cell>& cells) = 0;
  virtual void end() = 0;
};

/// Runs what a user typed, one or several statements, on a database opened for reading; beside the
/// tables and views there is `trace_samples(trace)` (trace_samples.h). Statements
/// that would change anything, here or in another file, are refused. Throws `BadInput` with the place in
/// the text for faults of the SQL, `Interrupted` when the user does not want to wait, else `Error`.
void run_queries(const Database& database, const std::string& sql, QueryOutput& output);

/// Prepares the statements of a text one after the other and hands each to `run`, which returns false at a fault, whose
/// description the connection holds. Throws as `run_queries` does, and `BadInput` when the time of `reading` is over.
/// For storage/ alone.
void for_each_statement(const Database& database, const std::string& sql, const ReadingOnly& reading,
                        const std::function<bool(sqlite3_stmt*)>& run);

/// Whether there was no memory for a value of the row that was just read.
bool has_no_memory(sqlite3_stmt* statement);

/// What the comments in schema/views.sql say about a view.
struct ViewDescription {
  std::string name;
  std::string sentence;
  std::string example;
};
std::vector<ViewDescription> view_descriptions();

}  // namespace lacuna
