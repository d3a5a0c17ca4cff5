#include "storage/files/connection.h"

#include "storage/files/callback.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <sqlite3.h>

#include <cstdlib>
#include <filesystem>
#include <new>
#include <string_view>
#include <utility>
#include <vector>

namespace lacuna {
namespace {

/// Several versions of SQLite, 3.40 among them, take their own JSON functions for unsafe where the schema is not
/// trusted.
bool json_works_untrusted() {
  SQLite::Database probe(":memory:", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  sqlite3_db_config(probe.getHandle(), SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  return probe.tryExec("CREATE TABLE t (a CHECK (json_valid(a))); INSERT INTO t VALUES ('1')") == SQLITE_OK;
}

struct FunctionName {
  std::string name;
  int arguments = 0;
};

/// Those that are no part of SQLite's core: of full-text search, of R-trees, of libraries loaded into every connection.
std::vector<FunctionName> added_functions(sqlite3* handle) {
  enum Column { kName, kBuiltIn, kArguments = 4 };
  const auto take = [](void* list, int, char** values, char**) {
    return called_back([&] {
      if (std::string_view(values[kBuiltIn]) == "0")
        static_cast<std::vector<FunctionName>*>(list)->push_back({values[kName], std::atoi(values[kArguments])});
    });
  };
  std::vector<FunctionName> added;
  const int result = sqlite3_exec(handle, "PRAGMA function_list", take, &added, nullptr);
  if (result == SQLITE_NOMEM || result == SQLITE_ABORT) throw std::bad_alloc();
  return added;
}

/// What is not there cannot be called by a view, a check or a column of a stranger's file.
void remove_what_reaches_out(sqlite3* handle) {
  const char* modules[] = {"json_each", "json_tree", nullptr};
  sqlite3_drop_modules(handle, modules);
  for (const auto& [name, arguments] : added_functions(handle))
    sqlite3_create_function_v2(handle, name.c_str(), arguments, SQLITE_UTF8, nullptr, nullptr, nullptr, nullptr,
                               nullptr);
}

void distrust(sqlite3* handle) {
  static const int kTrusted = json_works_untrusted() ? 0 : 1;
  const std::pair<int, int> settings[] = {{SQLITE_DBCONFIG_DEFENSIVE, 1},
                                          {SQLITE_DBCONFIG_TRUSTED_SCHEMA, kTrusted},
                                          {SQLITE_DBCONFIG_ENABLE_TRIGGER, 0},  // we have none
                                          {SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION, 0},
                                          {SQLITE_DBCONFIG_ENABLE_FKEY, 1}};
  for (const auto& [setting, value] : settings) sqlite3_db_config(handle, setting, value, nullptr);
  remove_what_reaches_out(handle);
}

}  // namespace

std::unique_ptr<SQLite::Database> open_connection(const std::string& name, int flags) {
  auto connection = std::make_unique<SQLite::Database>(name, flags | SQLITE_OPEN_EXRESCODE, kBusyTimeoutMs);
  distrust(connection->getHandle());
  return connection;
}

void end_when_due(SQLite::Database& connection, const Stop& stop) {
  constexpr int kOperationsBetweenLooks = 10000;  // of SQLite's machine, well under a millisecond
  const auto is_due = [](void* asked) { return static_cast<const Stop*>(asked)->is_due() ? 1 : 0; };
  sqlite3_progress_handler(connection.getHandle(), kOperationsBetweenLooks, is_due, const_cast<Stop*>(&stop));
}

std::string uri_of(const std::string& file) {
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(file).string()) {
    if (c == '?' || c == '#' || c == '%') {
      static constexpr char kDigits[] = "0123456789ABCDEF";
      uri += {'%', kDigits[static_cast<unsigned char>(c) >> 4U], kDigits[static_cast<unsigned char>(c) & 15U]};
    } else {
      uri += c;
    }
  }
  return uri;
}

}  // namespace lacuna
