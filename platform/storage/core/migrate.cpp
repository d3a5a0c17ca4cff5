#include "storage/core/migrate.h"

#include "foundation/digest.h"
#include "foundation/text/problem.h"
#include "storage/core/statement.h"
#include "storage/core/storage_error.h"
#include "storage/files/connection.h"

#include <lacuna/error.h>

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <sqlite3.h>

#include <unistd.h>

namespace lacuna {
namespace {

constexpr int kFarNewer = 1000;  ///< more versions than a program will have

int version_of(const Database& database) {
  Statement statement(database, "PRAGMA user_version");
  statement.step();
  return statement.number(0);
}

int application_of(const Database& database) {
  Statement statement(database, "PRAGMA application_id");
  statement.step();
  return statement.number(0);
}

bool is_empty(const Database& database) {
  Statement statement(database, "SELECT count(*) FROM sqlite_master");
  statement.step();
  return statement.integer(0) == 0;
}

/// Put in place once it is whole, so that there is an earlier copy until then. Another process may bring the file up to
/// date meanwhile: what it is then is no copy of an older version.
void put_in_place(const std::filesystem::path& draft, const std::filesystem::path& copy, int newest) {
  const auto made = open_connection(draft.string(), SQLite::OPEN_READONLY);
  const bool older = made->execAndGet("PRAGMA user_version").getInt() < newest;
  if (older) std::filesystem::rename(draft, copy);
}

std::filesystem::path copy_name(const Database& database, int newest) {
  return database.file().string() + ".before-version-" + std::to_string(newest);
}

void copy_before(const Database& database, int newest) {
  const std::string copy = copy_name(database, newest).string();
  const std::string draft = copy + "." + std::to_string(getpid()) + ".draft";
  std::error_code ignored;
  std::filesystem::remove(draft, ignored);
  try {
    Statement(database, "VACUUM INTO ?").run_with(draft);
    put_in_place(draft, copy, newest);
    std::filesystem::remove(draft, ignored);
  } catch (const std::exception& error) {
    std::filesystem::remove(draft, ignored);
    throw Error(std::string(error.what()) + "; this happened while it was copied to " + copy +
                " , before the update to the current schema");
  }
}

void apply(Database& database, const Migration& migration, int version) {
  try {
    database.connection().exec(migration.sql);
  } catch (const SQLite::Exception& error) {
    if (error.getErrorCode() != SQLITE_ERROR) throw_storage_error(database.file(), error);
    throw Error(database.file().string() + ": its header says schema " + std::to_string(version) +
                ", but its tables differ from that schema (" + error.what() +
                "); it was not changed. If its user_version was changed, restore the number: sqlite3 FILE "
                "\"PRAGMA user_version = N\"; else restore a copy");
  }
}

}  // namespace

void check_header(const Database& database, const std::vector<Migration>& migrations) {
  // In this order: another process that makes the same file sets both in one transaction.
  const bool empty = is_empty(database);
  const int application = application_of(database);
  if (application != kApplicationId && !(application == 0 && empty)) {
    throw_problem({database.file().string()},
                  "is not a Lacuna database but that of another program; name another file");
  }
  const int version = version_of(database);
  if (version < 0 || version > migrations.back().number + kFarNewer)
    throw Error(database.file().string() + ": its header says schema " + std::to_string(version) +
                ", which no version of Lacuna writes; its header was changed or is damaged. Restore a backup, or set "
                "the number that "
                "it had: sqlite3 FILE \"PRAGMA user_version = N\"");
  if (version > migrations.back().number) {
    throw Error(database.file().string() + ": was written by a newer Lacuna (schema " + std::to_string(version) +
                ", this program knows " + std::to_string(migrations.back().number) + "); use the newer version");
  }
  if (version > 0 && is_empty(database))  // now: the other process has made its tables
    throw Error(database.file().string() + ": has the header of schema " + std::to_string(version) +
                " but no tables; it is damaged and was not changed. Restore a backup, or name another file");
}

bool is_of_version(const Database& database, const std::vector<Migration>& migrations) {
  return version_of(database) == migrations.back().number;
}

void migrate(Database& database, const std::vector<Migration>& migrations) {
  if (is_of_version(database, migrations)) return;
  const std::filesystem::path copy = copy_name(database, migrations.back().number);
  const bool had_copy = std::filesystem::exists(copy);
  if (version_of(database) > 0) copy_before(database, migrations.back().number);
  try {
    bring_up_to_date(database, migrations);
  } catch (const Error&) {
    std::error_code ignored;
    if (!had_copy && !is_of_version(database, migrations)) std::filesystem::remove(copy, ignored);
    throw;
  }
}

void bring_up_to_date(Database& database, const std::vector<Migration>& migrations) {
  Transaction transaction(database);
  const int version = version_of(database);  // another process may have been faster
  for (const Migration& migration : migrations) {
    if (migration.number <= version) continue;
    apply(database, migration, version);
    database.execute("PRAGMA user_version = " + std::to_string(migration.number));
  }
  transaction.commit();
}

void refresh_views(Database& database, const std::string& views) {
  const std::string digest = sha256(views);
  const auto current = [&] {
    Statement stored(database, "SELECT sha256 FROM schema_text WHERE name = 'views'");
    return stored.step() && stored.text(0) == digest;
  };
  if (current()) return;
  Transaction transaction(database);
  std::vector<std::string> old;
  Statement names(database, "SELECT name FROM sqlite_master WHERE type = 'view'");
  while (names.step()) old.push_back(names.text(0));
  for (const std::string& name : old) database.execute("DROP VIEW " + name_in_sql(name));
  database.execute(views);
  Statement(database, "INSERT OR REPLACE INTO schema_text (name, sha256) VALUES ('views', ?)").run_with(digest);
  transaction.commit();
}

}  // namespace lacuna
