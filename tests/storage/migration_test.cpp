#include "storage/asked.h"
#include "storage/child_process.h"
#include "storage/core/statement.h"
#include "storage/made_up_run.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace lacuna {
namespace {

using test::ask;

/// A file as version 1 left it: its tables, its view of traces, a trial with what was measured and a prediction.
void make_version_1(const std::filesystem::path& file) {
  Database old = Database::open(file, {schema_migrations().front()});
  old.execute(
      "CREATE VIEW traces AS SELECT trace.id, comparison FROM trace;"
      "INSERT INTO schema_text VALUES ('views', 'those of version 1');"
      "INSERT INTO run VALUES (1, '00112233445566778899aabbccddeeff', NULL, 'lacuna compare', 1, 1, '2026', NULL, "
      "NULL);"
      "INSERT INTO experiment VALUES (1, 'rig');"
      "INSERT INTO experiment_text VALUES (1, 1, printf('%064d', 5), 'rig.toml', '[engine]', '[]');"
      "INSERT INTO revision VALUES (1, 1, 1, NULL, printf('%064d', 1), 'declared', '{}', '[]', '[]', '{}', '', '[]',"
      " '[]', 'rigid');"
      "INSERT INTO trial VALUES (1, 1, 'sine', 'sine.csv', printf('%064d', 2), 0, 1.0, 3);"
      "INSERT INTO comparison VALUES (1, 1, 'as_written', NULL, NULL, 0.001, '[]');"
      "INSERT INTO trace VALUES (5, 1, NULL, 'measured', '[]', 3, 'float64', x'01', x'02', printf('%064d', 3));"
      "INSERT INTO trace VALUES (7, 1, 1, 'predicted', '[]', 3, 'float32', x'03', x'04', printf('%064d', 4))");
}

class MigrationTest : public testing::Test {
 protected:
  TestFolder folder_;
  std::filesystem::path file_ = folder_ / "rig.db";
};

TEST_F(MigrationTest, AFileOfVersion1KeepsItsContentAndTakesRunsOfTheAlgorithm) {
  make_version_1(file_);
  {
    const Database migrated = Database::open(file_);
    EXPECT_EQ(ask(migrated, "PRAGMA user_version"), schema_migrations().back().number);
    EXPECT_EQ(ask(migrated,
                  "SELECT count(*) FROM trace WHERE id = 5 AND kind = 'measured' AND comparison IS NULL"
                  " AND model IS NULL AND times = x'01' AND samples = x'02' AND sample_count = 3"),
              1);
    EXPECT_EQ(ask(migrated,
                  "SELECT count(*) FROM trace WHERE id = 7 AND comparison = 1 AND precision = 'float32'"
                  " AND samples = x'04' AND digest = printf('%064d', 4)"),
              1);
    EXPECT_EQ(ask(migrated,
                  "SELECT count(*) FROM experiment_text WHERE decided->>0 = 'engine.engine=\"ode\"'"
                  " AND decided->>1 = 'engine.substeps=1'"),
              1);
    EXPECT_EQ(ask(migrated, "SELECT count(*) FROM traces WHERE trial = 'sine'"), 2) << "the views are today's";
    EXPECT_EQ(ask(migrated, "SELECT count(*) FROM pragma_foreign_key_check"), 0);
  }
  test::MadeUpDatabase filled(file_);
  const test::MadeUpRun made_up;
  filled.advance(made_up, made_up.commits());
  EXPECT_EQ(ask(filled.database, "SELECT count(*) FROM trace WHERE model IS NOT NULL"), 4);
  EXPECT_EQ(filled.run.value, 2);
}

TEST_F(MigrationTest, AMigratedFileHasTheTablesOfANewOne) {
  make_version_1(file_);
  const char* const tables =
      "SELECT count(*) || group_concat(replace(replace(sql, '\"', ''), ' ', '')) FROM (SELECT * FROM sqlite_master"
      " WHERE sql IS NOT NULL ORDER BY name)";
  const auto text = [&](const Database& database) {
    Statement statement(database, tables);
    statement.step();
    return statement.text(0);
  };
  EXPECT_EQ(text(Database::open(file_)), text(Database::open(folder_ / "new.db")));
}

TEST_F(MigrationTest, TheTableOfTracesRefusesOwnersThatDoNotFit) {
  test::MadeUpDatabase filled(file_);
  const test::MadeUpRun made_up;
  filled.advance(made_up, made_up.commits());
  for (const char* change :
       {"UPDATE trace SET model = NULL WHERE kind = 'predicted'", "UPDATE trace SET model = 7 WHERE kind = 'predicted'",
        "UPDATE trace SET model = (SELECT min(id) FROM model) WHERE kind = 'measured'",
        "UPDATE trace SET kind = 'guessed' WHERE kind = 'measured'", "UPDATE model SET pass = pass + (1 << 40)",
        "UPDATE pass SET number = number + 1"}) {
    EXPECT_THROW(filled.database.execute(change), Error) << change;
  }
}

TEST_F(MigrationTest, ProcessesThatRaceKeepACopyOfTheOlderVersion) {
  for (int round = 0; round < 10; ++round) {
    const std::filesystem::path file = folder_ / (std::to_string(round) + ".db");
    make_version_1(file);
    std::vector<std::unique_ptr<test::ChildProcess>> processes;
    for (int i = 0; i < 4; ++i)
      processes.push_back(std::make_unique<test::ChildProcess>([&](int) { Database::open(file); }));
    for (const auto& process : processes) EXPECT_EQ(process->all(), "");
    const Database copy =
        Database::open(file.string() + ".before-version-" + std::to_string(schema_migrations().back().number),
                       {schema_migrations().front()});
    EXPECT_EQ(ask(copy, "PRAGMA user_version"), 1);
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / ""))
    EXPECT_NE(entry.path().extension(), ".draft") << entry.path();
}

TEST_F(MigrationTest, AFileOfVersion1HasNoRunsOfTheAlgorithm) {
  make_version_1(file_);
  EXPECT_TRUE(eea_runs(Database::open_read_only(file_)).empty());
}

}  // namespace
}  // namespace lacuna
