#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace SQLite {
class Database;
}

namespace hidden_effects {

/// NULL, integer, real or text. A NaN is stored as NULL.
using Cell = std::variant<std::monostate, std::int64_t, double, std::string>;
using Row = std::vector<Cell>;

/// What a cell holds; NULL is NaN or no text.
double real(const Cell& cell);
std::int64_t integer(const Cell& cell);
std::string text(const Cell& cell);

/// Texts as one value, for `IN (SELECT value FROM json_each(?))`.
Cell list_cell(const std::vector<std::string>& texts);

enum class Access { read, write };

/// The benchmark's own SQLite file (schema.sql). Several processes may write to one; a transaction waits a minute for
/// another's. One thread at a time. What fails throws `std::runtime_error` with a sentence that names the file.
class Database {
 public:
  /// To write, makes the file if there is none; to read, changes nothing in it. The views (figures/views.sql) exist for
  /// this connection alone. Throws `std::invalid_argument` for a file that is no such database, or lacks tables.
  explicit Database(const std::filesystem::path& file, Access access = Access::write);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  /// Statements without parameters.
  void execute(const std::string& statements);
  /// One statement that reads, with `?` for each of the values.
  std::vector<Row> query(const std::string& statement, const Row& values = {}) const;
  /// One that writes.
  void change(const std::string& statement, const Row& values) { query(statement, values); }

 private:
  void make_if_empty();
  void check() const;
  [[noreturn]] void refuse(const std::string& reason) const;  ///< the file itself
  [[noreturn]] void complain(const char* reason) const;

  std::filesystem::path file_;
  std::unique_ptr<SQLite::Database> connection_;
};

/// What is not committed when it ends is rolled back.
class Transaction {
 public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database& database_;
  bool open_ = true;
};

}  // namespace hidden_effects
