#include "storage/made_up_run.h"
#include "storage/queries/verification.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace lacuna {
namespace {

using test::add_made_up_run;
using test::fill_small_database;
using test::MadeUpDatabase;
using test::MadeUpRun;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::IsEmpty;
using testing::SizeIs;

class VerificationTest : public testing::Test {
 protected:
  std::filesystem::path file() const { return folder_ / "rig.db"; }
  /// A run of each kind.
  void fill() const {
    Database database = Database::open(file());
    ResultStore store(database);
    fill_small_database(store);
    store.end_run(RunEnding::done);
    add_made_up_run(database);
  }
  void change(const std::string& sql) const { SQLite::Database(file().string(), SQLite::OPEN_READWRITE).exec(sql); }
  Verification verified() const { return verify(Database::open_read_only(file())); }
  std::vector<std::string> broken_tables() const {
    std::vector<std::string> tables;
    for (const BrokenSeal& broken : verified().seals.broken) tables.push_back(broken.table);
    return tables;
  }

  TestFolder folder_;
};

TEST_F(VerificationTest, FindsNothingWrongWithWhatWasStored) {
  fill();
  const Verification found = verified();
  EXPECT_TRUE(found.is_sound());
  EXPECT_THAT(found.damage, IsEmpty());
  EXPECT_THAT(found.seals.sealed, ElementsAre(RunId{1}, RunId{2}));
  EXPECT_THAT(found.seals.not_ended, IsEmpty());
}

/// A table that a later version adds is sealed, or said here to change after a run has ended.
TEST_F(VerificationTest, CoversEveryTable) {
  fill();
  const SQLite::Database database(file().string());
  SQLite::Statement table(database, "SELECT name FROM sqlite_schema WHERE type = 'table'");
  const std::vector<std::string> sealed = sealed_tables();
  std::set<std::string> covered(sealed.begin(), sealed.end());
  covered.insert({"seal", "schema_text", "unfinished_diagnosis", "claim"});
  while (table.executeStep()) EXPECT_THAT(covered, Contains(table.getColumn(0).getString()));
  EXPECT_THAT(covered, SizeIs(sealed.size() + 4));
}

TEST_F(VerificationTest, NamesWhatIsNotAsStored) {
  fill();
  change("UPDATE fitted_value SET value = value * (1 + 1e-15) WHERE position = 0");
  EXPECT_THAT(broken_tables(), ElementsAre("fitted_value"));
  change("DELETE FROM noise_floor");
  EXPECT_THAT(broken_tables(), ElementsAre("fitted_value", "noise_floor"));
  change("INSERT INTO failed_trial SELECT id + 1, run, experiment, trial, test, failed, reason FROM failed_trial");
  EXPECT_THAT(broken_tables(), ElementsAre("fitted_value", "noise_floor", "failed_trial"));
}

TEST_F(VerificationTest, NamesATextAndATraceThatAreNotTheirDigests) {
  fill();
  change(
      "UPDATE trace SET samples = zeroblob(length(samples)) WHERE kind = 'measured'; "
      "UPDATE experiment_text SET text = text || '#' WHERE id IN (SELECT min(id) FROM experiment_text)");
  EXPECT_THAT(broken_tables(), ElementsAre("experiment_text", "trace", "trace"));
  EXPECT_THAT(verified().damage, SizeIs(4)) << "three traces and a text";
}

TEST_F(VerificationTest, TellsWhatIsNotCovered) {
  {
    MadeUpDatabase running(file());
    running.advance(MadeUpRun(), 2);
    running.store->hand_over();
  }
  change("UPDATE run SET ended = NULL, ending = NULL; DELETE FROM seal");
  EXPECT_THAT(verified().seals.not_ended, ElementsAre(RunId{1}));
  change("UPDATE run SET ended = '2026-01-01T00:00:00Z', ending = 'done'");
  EXPECT_THAT(verified().seals.ended_unsealed, ElementsAre(RunId{1}));
  EXPECT_TRUE(verified().is_sound());
}

/// What goes on has no seal; at its end it gets another.
TEST_F(VerificationTest, ARunThatIsGoneOnWithIsSealedAnew) {
  const MadeUpRun made_up;
  MadeUpDatabase running(file());
  running.advance(made_up, 3);
  running.store->end(RunEnding::interrupted);
  EXPECT_THAT(verified().seals.sealed, ElementsAre(RunId{1}));
  running.store.emplace(running.database, running.writing, running.run, running.experiment);
  running.advance(made_up, 4);
  EXPECT_THAT(verified().seals.not_ended, ElementsAre(RunId{1}));
  running.advance(made_up, made_up.commits());
  running.store->end(RunEnding::done);
  EXPECT_THAT(verified().seals.sealed, ElementsAre(RunId{1}));
  EXPECT_TRUE(verified().is_sound());
}

/// Another command knows more of a trial that the run has stored.
TEST_F(VerificationTest, WhatARunHasEndedWithIsNotAddedTo) {
  Database database = Database::open(file());
  ResultStore store(database);
  TrialRecord trial{.name = "swing", .file = "swing.csv", .digest = test::kSomeDigest, .duration = 1.0, .samples = 3};
  trial.setup = {"weights", {{"body.arm.mass", 0.5}}};
  for (const char* unit : {"", "kg"}) {
    trial.setting_units = {unit};
    store.begin_run({.command = "lacuna run"}, {});
    store.find_or_add_trial(store.record_experiment({"rig", "rig.toml", "[experiment]", {}}), trial);
    store.end_run(RunEnding::done);
  }
  EXPECT_THAT(broken_tables(), IsEmpty());
}

/// A column that a later version adds to a table is not part of what was sealed before.
TEST_F(VerificationTest, ColumnsOfLaterVersionsChangeNoSeal) {
  fill();
  change("ALTER TABLE fit ADD COLUMN weight REAL DEFAULT 1.5");
  EXPECT_THAT(broken_tables(), IsEmpty());
}

struct Stretch {
  std::size_t begin = 0, end = 0;  ///< bytes of the file
};

/// Where the file has the rows of its tables: the used parts of their pages.
std::vector<Stretch> content_of(const std::filesystem::path& file, const std::string& bytes) {
  const std::vector<std::string> sealed = sealed_tables();
  std::vector<Stretch> stretches;
  const SQLite::Database database(file.string());
  SQLite::Statement page(database, "SELECT name, pagetype, pgoffset, pgsize, unused FROM dbstat");
  while (page.executeStep()) {
    if (std::find(sealed.begin(), sealed.end(), page.getColumn(0).getString()) == sealed.end()) continue;
    const auto at = static_cast<std::size_t>(page.getColumn(2).getInt64());
    const auto size = static_cast<std::size_t>(page.getColumn(3).getInt64());
    if (page.getColumn(1).getString() == "overflow") {
      stretches.push_back({at, at + size - static_cast<std::size_t>(page.getColumn(4).getInt64())});
    } else {  // cells are at the end; the header says where they begin
      const auto byte = [&](std::size_t i) {
        return static_cast<std::size_t>(static_cast<unsigned char>(bytes[at + i]));
      };
      stretches.push_back({at + 256 * byte(5) + byte(6), at + size});
    }
  }
  return stretches;
}

bool is_found(const std::filesystem::path& file) try {
  return !verify(Database::open_read_only(file)).is_sound();
} catch (const Error&) {
  return true;
}

bool sqlite_finds(const std::filesystem::path& file) try {
  SQLite::Database database(file.string());
  return database.execAndGet("PRAGMA integrity_check").getString() != "ok";
} catch (const std::exception&) {
  return true;
}

/// All rows with their types and bits, as SQLite reads them. Nothing reads every bit: not those that are unused, nor
/// what a row has in the place of its key.
std::string rows_of(const std::filesystem::path& file) try {
  const SQLite::Database database(file.string());
  std::string rows;
  for (const std::string& table : sealed_tables()) {
    SQLite::Statement row(database, "SELECT * FROM " + table);
    while (row.executeStep())
      for (int i = 0; i < row.getColumnCount(); ++i)
        rows += std::to_string(row.getColumn(i).getType()) + ' ' + row.getColumn(i).getString() + '\n';
  }
  return rows;
} catch (const std::exception& unreadable) {
  return unreadable.what();
}

TEST_F(VerificationTest, FindsEveryFlippedBit) {
  fill();
  const std::filesystem::path whole = folder_ / "whole.db", flipped = folder_ / "flipped.db";
  change("PRAGMA journal_mode = DELETE; VACUUM INTO '" + whole.string() + "'");
  ASSERT_FALSE(is_found(whole));
  std::ifstream stream(whole, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  const std::vector<Stretch> stretches = content_of(whole, bytes);
  std::vector<std::size_t> places;
  for (const Stretch& stretch : stretches)
    for (std::size_t i = stretch.begin; i < stretch.end; ++i) places.push_back(i);
  ASSERT_GT(places.size(), 10'000U);

  constexpr int kFlips = 50;
  std::mt19937_64 random(1);
  const std::string rows = rows_of(whole);
  int by_sqlite = 0;
  for (int i = 0; i < kFlips;) {
    const std::size_t place = places[random() % places.size()];
    const auto bit = static_cast<unsigned char>(1U << (random() % 8));
    std::string changed = bytes;
    changed[place] = static_cast<char>(static_cast<unsigned char>(changed[place]) ^ bit);
    std::ofstream(flipped, std::ios::binary) << changed;
    if (rows_of(flipped) == rows) continue;
    ++i;
    EXPECT_TRUE(is_found(flipped)) << "byte " << place << ", bit " << int{bit};
    by_sqlite += sqlite_finds(flipped) ? 1 : 0;
  }
  RecordProperty("found_by_sqlite_alone", by_sqlite);
  EXPECT_LT(by_sqlite, kFlips) << "SQLite alone would do";
}

}  // namespace
}  // namespace lacuna
