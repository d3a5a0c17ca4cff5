// How the fuzzer changes a shard: the values of some rows, by SQL and against all rules, or, if that fails, some bytes
// of the file.

#include <fmt/format.h>
#include <sqlite3.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <random>
#include <string>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

using Dice = std::minstd_rand;

constexpr std::size_t kHeader = 100;                        // bytes
constexpr std::array<std::size_t, 2> kVersions = {18, 19};  // offsets of what says that there is a write-ahead log
constexpr std::size_t kPiece = 64;                          // bytes changed at once

const std::array kValues = {"NULL",  "0",     "1",         "-1",     "9223372036854775807", "-9223372036854775808",
                            "1e308", "9e999", "''",        "'x'",    "zeroblob(7)",         "8388607",
                            "'[]'",  "'{}'",  "'[\"x\"]'", "'done'", "printf('%064d', 1)",  "1099511627777"};

std::vector<std::string> texts(sqlite3* database, const std::string& sql) {
  std::vector<std::string> found;
  const auto take = [](void* list, int, char** values, char**) {
    static_cast<std::vector<std::string>*>(list)->emplace_back(values[0] ? values[0] : "");
    return 0;
  };
  sqlite3_exec(database, sql.c_str(), take, &found, nullptr);
  return found;
}

template <class List>
std::string one_of(const List& list, Dice& dice) {
  return list.empty() ? std::string("none") : std::string(list[dice() % list.size()]);
}

std::string edit(sqlite3* database, Dice& dice) {
  const std::string table =
      one_of(texts(database, "SELECT name FROM sqlite_schema WHERE type = 'table' AND name NOT LIKE 'sqlite%'"), dice);
  const std::vector<std::string> columns = texts(database, "SELECT name FROM pragma_table_info('" + table + "')");
  const std::string column = one_of(columns, dice);
  const std::string some = fmt::format("WHERE abs(random()) % {} = 0", 1 + dice() % 8);
  switch (dice() % 16) {
    case 0: return fmt::format("DELETE FROM \"{}\" {}", table, some);
    case 1: return fmt::format("ALTER TABLE \"{}\" DROP COLUMN \"{}\"", table, column);
    case 2: return fmt::format("ALTER TABLE \"{}\" RENAME TO \"{}_2\"", table, table);
    case 3: return fmt::format("PRAGMA user_version = {}", dice() % 20);
    case 4: return "DELETE FROM seal";
    case 5: return fmt::format("UPDATE \"{0}\" SET \"{1}\" = \"{1}\" + {2} {3}", table, column, dice() % 3, some);
    case 6: return fmt::format("UPDATE \"{}\" SET \"{}\" = \"{}\" {}", table, column, one_of(columns, dice), some);
    case 7:
      return fmt::format("UPDATE OR REPLACE \"{}\" SET \"{}\" = {} {}", table, column, one_of(kValues, dice), some);
    default:
      return fmt::format("UPDATE OR IGNORE \"{}\" SET \"{}\" = {} {}", table, column, one_of(kValues, dice), some);
  }
}

void set_versions(std::uint8_t* file, std::uint8_t version) {
  for (const std::size_t offset : kVersions) file[offset] = version;
}

using Connection = std::unique_ptr<sqlite3, int (*)(sqlite3*)>;

/// The size of the file afterwards; 0 where it is no database, or becomes too large.
std::size_t edited(std::uint8_t* data, std::size_t size, std::size_t max_size, Dice& dice) {
  if (size < kHeader) return 0;
  sqlite3* opened = nullptr;
  sqlite3_open(":memory:", &opened);
  const Connection database(opened, sqlite3_close);
  auto* copy = static_cast<std::uint8_t*>(sqlite3_malloc64(size));
  std::memcpy(copy, data, size);
  const std::uint8_t version = data[kVersions[0]];
  set_versions(copy, 1);
  const auto bytes = static_cast<sqlite3_int64>(size);
  constexpr unsigned kOwned = SQLITE_DESERIALIZE_FREEONCLOSE | SQLITE_DESERIALIZE_RESIZEABLE;
  if (sqlite3_deserialize(opened, "main", copy, bytes, bytes, kOwned) != SQLITE_OK) return 0;
  sqlite3_exec(opened, "PRAGMA foreign_keys = OFF; PRAGMA ignore_check_constraints = ON", nullptr, nullptr, nullptr);
  bool any = false;
  for (auto edits = 1 + dice() % 3; edits > 0; --edits)
    any |= sqlite3_exec(opened, edit(opened, dice).c_str(), nullptr, nullptr, nullptr) == SQLITE_OK;
  sqlite3_int64 length = 0;
  const std::unique_ptr<std::uint8_t, void (*)(void*)> file(sqlite3_serialize(opened, "main", &length, 0),
                                                            sqlite3_free);
  if (!any || !file || static_cast<std::size_t>(length) > max_size) return 0;
  std::memcpy(data, file.get(), static_cast<std::size_t>(length));
  set_versions(data, version);
  return static_cast<std::size_t>(length);
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  Dice dice(seed);
  dice.discard(4);
  if (dice() % 4 != 0)
    if (const std::size_t length = edited(data, size, max_size, dice); length > 0) return length;
  if (size <= kPiece) return LLVMFuzzerMutate(data, size, max_size);
  std::uint8_t* piece = data + dice() % (size - kPiece);
  LLVMFuzzerMutate(piece, kPiece, kPiece);
  return size;
}
