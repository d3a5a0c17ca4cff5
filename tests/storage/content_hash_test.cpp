#include "storage/core/statement.h"
#include "storage/made_up_run.h"

#include <gtest/gtest.h>

#include <bit>
#include <set>

namespace lacuna {
namespace {

using test::MadeUpDatabase;
using test::MadeUpRun;

/// A small run, so that changing each column in turn stays quick.
constexpr MadeUpRun kSmall{.passes = 2, .generations = 1, .models = 9, .tests = 6, .samples = 3};

/// Tables that hold nothing of what a run of the algorithm found.
const std::set<std::string> kNotContent = {"schema_text",
                                           "experiment",
                                           "experiment_text",
                                           "run",
                                           "provenance",
                                           "plugin_file",
                                           "revision",
                                           "fit",
                                           "revision_use",
                                           "fit_stage",
                                           "fitted_value",
                                           "holdout_look",
                                           "comparison",
                                           "noise_floor",
                                           "numerical_error",
                                           "work_time",
                                           "comparison_score",
                                           "checkpoint",
                                           "robot_file",
                                           "carried_out",
                                           "diagnosis",
                                           "candidate_model",
                                           "candidate_value",
                                           "unfinished_diagnosis",
                                           "failed_trial",
                                           "where_it_fails",
                                           "seal",
                                           "claim"};

/// Columns of content tables that are a row's address in its file, a name that carries the run's number, or what
/// follows from other columns.
const std::set<std::string> kNotContentColumns = {
    "eea_run.experiment",  "trial.experiment",  "trial.name",  "trial.file",           "trace.id",
    "metric.id",           "trial.id",          "eea_run.run", "eea_run.fitness_unit", "invalid_model.reason",
    "invalid_test.reason", "trial_setting.unit"};

std::string hash_of(const MadeUpDatabase& filled) { return content_hash(filled.database, filled.run); }

/// Where a key no longer leads anywhere, there may be no content.
std::string hash_or_sentence(const MadeUpDatabase& filled) {
  try {
    return hash_of(filled);
  } catch (const Error& error) {
    return error.what();
  }
}

std::vector<std::string> texts(const Database& database, const std::string& sql) {
  Statement row(database, sql.c_str());
  std::vector<std::string> all;
  while (row.step()) all.push_back(row.text(0));
  return all;
}

constexpr std::int64_t kBit = 1 << 20;  ///< of a key or count, so that it does not become another row's

/// Flips one bit of a column's value, or makes one from NULL, in the row with the largest.
void change_one_bit(Database& database, const std::string& table, const std::string& column) {
  const std::string where = " FROM " + table + " ORDER BY " + column + " IS NULL, " + column + " DESC LIMIT 1";
  Statement row(database, ("SELECT " + column + ", typeof(" + column + ")" + where).c_str());
  ASSERT_TRUE(row.step()) << table << " is empty: the test would show nothing";
  const std::string type = row.text(1);
  const bool null = type == "null";
  const std::string update = "UPDATE " + table + " SET " + column + " = ?1 WHERE " + column +
                             (null ? " IS NULL" : " = ?2") + (null ? " AND ?2 = ?2" : "");
  const auto set = [&](const auto& from, const auto& to) { Statement(database, update.c_str()).run_with(to, from); };
  if (type == "integer") {
    const std::int64_t value = row.integer(0);
    set(value, value ^ kBit);
  } else if (type == "real") {
    const double value = row.real(0);
    set(value, std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) ^ 1U));
  } else if (type == "text") {
    std::string changed = row.text(0);
    changed.back() = static_cast<char>(changed.back() ^ 1);
    set(row.text(0), changed);
  } else if (type == "blob") {
    std::vector<std::byte> changed = row.bytes(0);
    changed.back() ^= std::byte{1};
    const std::vector<std::byte> value = row.bytes(0);
    set(std::span<const std::byte>(value), std::span<const std::byte>(changed));
  } else {
    set(0, 1);
  }
}

TEST(ContentHash, IsTheSameForTheSameRunInOneFileAndInTwo) {
  const TestFolder folder;
  MadeUpDatabase first(folder / "first.db");
  first.advance(kSmall, kSmall.commits());
  const std::string hash = hash_of(first);
  EXPECT_EQ(hash.size(), 64U);
  MadeUpDatabase second(folder / "second.db");
  second.advance(kSmall, kSmall.commits());
  EXPECT_EQ(hash_of(second), hash);
  MadeUpDatabase again(folder / "first.db");
  again.advance(kSmall, kSmall.commits());
  EXPECT_EQ(again.run.value, 2);
  EXPECT_EQ(hash_of(again), hash);
  EXPECT_EQ(hash_of(first), hash) << "another run in the file does not count";
}

TEST(ContentHash, DoesNotDependOnWhereTheRunWasInterrupted) {
  const TestFolder folder;
  MadeUpDatabase whole(folder / "whole.db");
  whole.advance(kSmall, kSmall.commits());
  for (int commits = 0; commits < kSmall.commits(); ++commits) {
    MadeUpDatabase parts(folder / (std::to_string(commits) + ".db"));
    parts.advance(kSmall, commits);
    EXPECT_NE(hash_of(parts), hash_of(whole)) << commits;
    parts.store.reset();
    parts.results.continue_run(parts.run);
    parts.store.emplace(parts.database, parts.writing, parts.run, parts.experiment);
    parts.advance(kSmall, kSmall.commits());
    EXPECT_EQ(hash_of(parts), hash_of(whole)) << commits;
  }
}

TEST(ContentHash, DoesNotDependOnWhenAndHow) {
  const TestFolder folder;
  MadeUpDatabase filled(folder / "run.db");
  filled.advance(kSmall, kSmall.commits());
  const std::string hash = hash_of(filled);
  filled.database.execute(
      "UPDATE run SET started = 'then', ended = 'later', threads = 64, command = 'other', seed = 9;"
      "UPDATE provenance SET processor = 'another'; UPDATE checkpoint SET seconds = 1e9");
  EXPECT_EQ(hash_of(filled), hash);
}

TEST(ContentHash, OneBitOfAnyColumnChangesIt) {
  const TestFolder folder;
  MadeUpDatabase filled(folder / "run.db");
  filled.advance(kSmall, kSmall.commits());
  const std::string hash = hash_of(filled);
  filled.database.execute("PRAGMA foreign_keys = OFF; PRAGMA ignore_check_constraints = ON");
  int columns = 0;
  for (const std::string& table : texts(filled.database, "SELECT name FROM sqlite_master WHERE type = 'table'")) {
    if (kNotContent.contains(table)) continue;
    for (const std::string& column : texts(filled.database, "SELECT name FROM pragma_table_info('" + table + "')")) {
      std::string name = table;
      if (kNotContentColumns.contains(name.append(".").append(column))) continue;
      filled.database.execute("SAVEPOINT change");
      change_one_bit(filled.database, table, column);
      EXPECT_NE(hash_or_sentence(filled), hash) << table << "." << column;
      filled.database.execute("ROLLBACK TO change; RELEASE change");
      ASSERT_EQ(hash_of(filled), hash);
      ++columns;
    }
  }
  EXPECT_GT(columns, 80);
}

TEST(ContentHash, OfARunWithoutModelsIsASentence) {
  const TestFolder folder;
  const MadeUpDatabase empty(folder / "run.db");
  EXPECT_THROW(hash_of(empty), Error);
}

}  // namespace
}  // namespace lacuna
