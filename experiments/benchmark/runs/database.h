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

/// The benchmark's own SQLite file (schema.sql). Several processes may write to one; a transaction waits a minute for
/// another's. One thread at a time. Everything throws `std::runtime_error` with a sentence that names the file.
class Database {
 public:
  /// Makes the file if there is none. The views (figures/views.sql) exist for this connection alone.
  explicit Database(const std::filesystem::path& file);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  /// Statements without parameters.
  void execute(const std::string& statements);
  /// One statement with `?` for each of the values.
  std::vector<Row> query(const std::string& statement, const Row& values = {});

 private:
  void check_header();
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
