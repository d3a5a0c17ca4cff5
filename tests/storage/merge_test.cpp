#include "foundation/text/problem.h"
#include "storage/asked.h"
#include "storage/core/statement.h"
#include "storage/made_up_run.h"
#include "storage/merge/merge.h"
#include "storage/queries/verification.h"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <mutex>
#include <string>
#include <vector>

namespace lacuna {
namespace {

using test::add_made_up_run;
using test::ask;
using test::fill_small_database;
using test::MadeUpDatabase;
using test::MadeUpRun;
using test::sentence_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr MadeUpRun kMadeUp{.passes = 2, .generations = 2, .models = 9, .tests = 6, .samples = 5};

class MergeTest : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }

  std::filesystem::path shard_with_run(const std::string& name, int replicate) const {
    MadeUpDatabase shard(file(name));
    add_run(*shard.store, replicate);
    return file(name);
  }
  static void add_run(EeaStore& store, int replicate) {
    EeaRunRecord record = kMadeUp.record();
    record.replicate = replicate;
    store.begin(record);
    for (int i = 0; i < kMadeUp.commits(); ++i) kMadeUp.commit(store, i);
    store.end(RunEnding::done);
  }
  std::filesystem::path shard_with_comparisons(const std::string& name) const {
    Database database = Database::open(file(name));
    ResultStore store(database);
    fill_small_database(store);
    store.end_run(RunEnding::done);
    return file(name);
  }
  std::vector<MergedShard> merged(const std::vector<std::filesystem::path>& files) const {
    Database all = Database::open(file("all.db"));
    std::vector<Shard> shards;
    for (const std::filesystem::path& path : files) shards.push_back({path});
    return merge(all, shards);
  }
  std::vector<std::string> hashes(const std::string& name) const {
    const Database database = Database::open_read_only(file(name));
    std::vector<std::string> all;
    for (const EeaRunListing& run : eea_runs(database)) all.push_back(content_hash(database, run.run));
    return all;
  }
  std::int64_t asked(const std::string& sql) const {
    return ask(Database::open_read_only(file("all.db")), sql.c_str());
  }

  TestFolder folder_;
};

/// The hash of a run says nothing of its number, so it is that of the same run in any file.
TEST_F(MergeTest, RunsHaveTheHashesThatTheyHadAndNumbersOfTheirOwn) {
  const auto first = shard_with_run("a.db", 1), second = shard_with_run("b.db", 2);
  const auto result = merged({first, second});
  ASSERT_EQ(result.size(), 2U);
  EXPECT_THAT(result[0].added, ElementsAre(RunId{1}));
  EXPECT_THAT(result[1].added, ElementsAre(RunId{2}));
  EXPECT_THAT(hashes("all.db"), ElementsAre(hashes("a.db")[0], hashes("b.db")[0]));
  EXPECT_EQ(asked("SELECT count(*) FROM trial WHERE name = 'run 2, trial 1'"), 1) << "named after the run";
  EXPECT_EQ(asked("SELECT count(*) FROM experiment"), 1);
  EXPECT_EQ(asked("SELECT count(*) FROM metric"), 2);
  EXPECT_EQ(asked("SELECT count(*) FROM model"), 72);
}

TEST_F(MergeTest, WhatIsMergedIsSealedAndWhole) {
  merged({shard_with_run("a.db", 1), shard_with_comparisons("c.db"), shard_with_comparisons("d.db")});
  const Verification found = verify(Database::open_read_only(file("all.db")));
  EXPECT_THAT(found.damage, IsEmpty());
  EXPECT_THAT(found.seals.broken, IsEmpty());
  EXPECT_THAT(found.seals.sealed, ElementsAre(RunId{1}, RunId{2}, RunId{3}));
}

TEST_F(MergeTest, OnceMoreChangesNothing) {
  const auto first = shard_with_run("a.db", 1), second = shard_with_comparisons("c.db");
  merged({first, second});
  const std::vector<std::string> before = hashes("all.db");
  const std::int64_t rows = asked("SELECT sum(rows) FROM seal");
  const auto again = merged({second, first, first});
  EXPECT_THAT(again[0].added, IsEmpty());
  EXPECT_THAT(again[1].known, ElementsAre(RunId{1}));
  EXPECT_EQ(hashes("all.db"), before);
  EXPECT_EQ(asked("SELECT sum(rows) FROM seal"), rows);
  EXPECT_EQ(asked("SELECT count(*) FROM run"), 2);
}

/// Trials, texts and revisions that are the same stand there once; looks at held-out data go on counting.
TEST_F(MergeTest, WhatRunsShareIsThereOnce) {
  const auto first = shard_with_comparisons("c.db"), second = shard_with_comparisons("d.db");
  const Database alone = Database::open_read_only(first);
  merged({first, second});
  for (const char* table : {"experiment", "experiment_text", "revision", "trial", "trial_condition"})
    EXPECT_EQ(asked(std::string("SELECT count(*) FROM ") + table),
              ask(alone, (std::string("SELECT count(*) FROM ") + table).c_str()))
        << table;
  for (const char* table : {"comparison", "fit", "holdout_look", "diagnosis", "comparison_score"})
    EXPECT_EQ(asked(std::string("SELECT count(*) FROM ") + table),
              2 * ask(alone, (std::string("SELECT count(*) FROM ") + table).c_str()))
        << table;
  EXPECT_EQ(asked("SELECT max(number) FROM holdout_look"), asked("SELECT count(*) FROM holdout_look"));
  EXPECT_EQ(
      asked("SELECT count(*) FROM comparison WHERE look IS NOT NULL"
            " AND look NOT IN (SELECT number FROM holdout_look WHERE holdout_look.id >> 40 = comparison.id >> 40)"),
      0);
  EXPECT_EQ(asked("SELECT count(*) FROM (SELECT 1 FROM trace WHERE comparison IS NULL AND model IS NULL"
                  " GROUP BY trial, kind HAVING count(*) > 1)"),
            0)
      << "measured once";
}

TEST_F(MergeTest, ADatabaseThatHasRunsKeepsThem) {
  {
    Database all = Database::open(file("all.db"));
    add_made_up_run(all);
  }
  const std::string own = hashes("all.db")[0];
  merged({shard_with_run("a.db", 7)});
  EXPECT_EQ(hashes("all.db")[0], own);
  EXPECT_EQ(asked("SELECT replicate FROM eea_run WHERE run = 2"), 7);
}

TEST_F(MergeTest, ARunThatHasGoneOnSinceIsNotTakenForTheEarlierState) {
  {
    MadeUpDatabase shard(file("a.db"));
    shard.advance(kMadeUp, 2);
    shard.store->end(RunEnding::interrupted);
  }
  merged({file("a.db")});
  EXPECT_THAT(merged({file("a.db")})[0].known, ElementsAre(RunId{1})) << "the same state";
  {
    Database database = Database::open(file("a.db"));
    std::mutex writing;
    EeaStore store(database, writing, RunId{1}, *ResultStore(database).find_experiment("quadruped"));
    store.begin(kMadeUp.record());
    store.checkpoint();
    for (int i = 2; i < kMadeUp.commits(); ++i) kMadeUp.commit(store, i);
    store.end(RunEnding::done);
  }
  EXPECT_THAT(test::sentence_of([&] { merged({file("a.db")}); }), HasSubstr("in an earlier state"));
}

TEST_F(MergeTest, NoShardIsMergedWhereALaterOneHasMoreOfItsRun) {
  {
    MadeUpDatabase shard(file("a.db"));
    shard.advance(kMadeUp, 2);
    shard.store->end(RunEnding::interrupted);
  }
  std::filesystem::copy_file(file("a.db"), file("b.db"));
  {
    Database database = Database::open(file("b.db"));
    set_run_ending(database, RunId{1}, RunEnding::failed);
  }
  SQLite::Database(file("b.db").string(), SQLite::OPEN_READWRITE).exec("UPDATE run SET ended = '2099-01-01T00:00:00Z'");
  EXPECT_THAT(test::sentence_of([&] {
                merged({file("a.db"), file("b.db")});
              }),
              testing::AllOf(HasSubstr("b.db: run 1 is also run 1 of "),
                             HasSubstr("a.db, in an earlier state; leave out that one")));
  EXPECT_EQ(asked("SELECT count(*) FROM run"), 0);
}

TEST_F(MergeTest, AShardThatIsLeftOutKeepsNoOtherOut) {
  const auto good = shard_with_run("a.db", 1), bad = shard_with_run("b.db", 2);
  SQLite::Database(bad.string(), SQLite::OPEN_READWRITE).exec("UPDATE model SET score = score * 2 WHERE score > 0");
  Database all = Database::open(file("all.db"));
  const auto result = merge(all, {{bad, Unusable::is_left_out}, {good}});
  EXPECT_TRUE(result[0].is_unsound);
  EXPECT_THAT(result[0].problems, testing::Not(IsEmpty()));
  EXPECT_THAT(result[1].added, ElementsAre(RunId{1}));
  EXPECT_THAT(sentence_of([&] {
                merge(all, {{good, Unusable::is_left_out}, {bad}});
              }),
              HasSubstr("b.db: run 1, table model: changed since the run ended"));
}

TEST_F(MergeTest, AFaultInOneShardKeepsAllOut) {
  const auto good = shard_with_run("a.db", 1), bad = shard_with_run("b.db", 2);
  SQLite::Database(bad.string(), SQLite::OPEN_READWRITE).exec("UPDATE model SET score = score * 2 WHERE score > 0");
  try {
    merged({good, bad, file("none.db")});
    FAIL() << "should have been refused";
  } catch (const BadInput& refused) {
    EXPECT_THAT(refused.what(), HasSubstr("b.db: run 1, table model: changed since the run ended"));
    EXPECT_THAT(refused.what(), HasSubstr("none.db"));
  }
  EXPECT_EQ(asked("SELECT count(*) FROM run"), 0);
}

/// Whoever changed the rows of runs that are not sealed, or tables, which no seal covers.
TEST_F(MergeTest, ShardsThatContradictThemselvesAreRefused) {
  const auto refusal = [&](const std::string& change) {
    const auto shard = shard_with_comparisons("c.db");
    SQLite::Database(shard.string(), SQLite::OPEN_READWRITE).exec("DELETE FROM seal; " + change);
    std::string said = sentence_of([&] { merged({shard}); });
    std::filesystem::remove(shard);
    EXPECT_EQ(asked("SELECT count(*) FROM run"), 0) << change;
    return said;
  };
  EXPECT_THAT(refusal("UPDATE holdout_look SET experiment = 3"),
              HasSubstr("c.db: a row of holdout_look refers to a missing row of experiment"));
  EXPECT_THAT(refusal("DROP TABLE work_time"),
              HasSubstr("c.db: table work_time differs from the one that this program makes"));
  EXPECT_THAT(refusal("ALTER TABLE fit ADD COLUMN more TEXT"),
              HasSubstr("table fit differs from the one that this program makes"));
  EXPECT_THAT(refusal("UPDATE experiment SET id = 7; UPDATE experiment_text SET experiment = 7;"
                      "UPDATE revision SET experiment = 7; UPDATE trial SET experiment = 7;"
                      "UPDATE holdout_look SET experiment = 7"),
              HasSubstr("c.db: has a row that refers to a missing row"));
}

TEST_F(MergeTest, RunsOfOneExperimentByTwoBuildsOfAPluginStayApart) {
  for (const auto& [name, build] : {std::pair{"a.db", 'a'}, std::pair{"b.db", 'b'}}) {
    MadeUpDatabase shard(file(name));
    shard.results.record_plugins({{std::string("/opt/") + build + "/search.so", std::string(64, build), ""}});
    add_run(*shard.store, 1);
  }
  try {
    merged({file("a.db"), file("b.db")});
    FAIL() << "should have been refused";
  } catch (const BadInput& refused) {
    EXPECT_THAT(refused.what(), HasSubstr("used another build of search.so than run 1 of quadruped in"));
  }
}

}  // namespace
}  // namespace lacuna
