#include "runs/case_store.h"
#include "runs/child_process.h"

#include "experiments/benchmark/small_results.h"
#include "support/test_folder.h"

#include <gmock/gmock.h>

namespace hidden_effects {
namespace {

class Archive : public testing::Test {
 protected:
  ChildOutcome archive(std::vector<std::string> words) const {
    words.insert(words.begin(), LACUNA_SOURCE_DIRECTORY "/experiments/benchmark/results/archive");
    return run_child(words, folder_.path(), 60.0, [] { return false; });
  }

  void make(const std::string& name, const std::vector<int>& numbers) const {
    Database database(folder_ / name);
    keep_version(database, "v", "0.1.0");
    for (const int number : numbers) {
      CaseResult result = small_case(number, "one_joint", {kCoulomb});
      result.diagnoses = {small_diagnosis(1, "effect_found", 0.9, {kCoulomb}, {kStribeck})};
      result.diagnoses[0].json = "{\"it's\":\n\"INSERT INTO bench_case\"}";
      keep_case(database, result);
    }
  }

  lacuna::TestFolder folder_;
};

TEST_F(Archive, WhatIsKeptIsRestoredAndMerged) {
  make("first.db", {0, 1});
  make("second.db", {1, 2});
  ASSERT_EQ(archive({"keep", "first.db", "first.sql.gz"}).code, 0);
  ASSERT_EQ(archive({"keep", "second.db", "second.sql.gz"}).code, 0);
  const ChildOutcome restored = archive({"restore", "all.db", "first.sql.gz", "second.sql.gz"});
  ASSERT_EQ(restored.code, 0) << restored.errors;
  EXPECT_EQ(restored.output, "3 cases in all.db\n");
  Database all(folder_ / "all.db");
  EXPECT_TRUE(has_case(all, "v", "tuning", 2));
  EXPECT_EQ(integer(all.query("SELECT count(*) FROM ranked_effect")[0][0]), 6);
  EXPECT_EQ(text(all.query("SELECT json FROM diagnosis WHERE number = 1")[0][0]),
            "{\"it's\":\n\"INSERT INTO bench_case\"}");
}

TEST_F(Archive, ACaseStaysWholeAndOfOneProgram) {
  make("first.db", {0, 1});
  ASSERT_EQ(archive({"keep", "first.db", "first.sql.gz"}).code, 0);
  make("some.db", {1});
  Database(folder_ / "some.db").execute("DELETE FROM ranked_effect");
  ASSERT_EQ(archive({"restore", "some.db", "first.sql.gz"}).code, 0);
  EXPECT_EQ(integer(Database(folder_ / "some.db").query("SELECT count(*) FROM ranked_effect WHERE number = 1")[0][0]),
            0);
  EXPECT_EQ(integer(Database(folder_ / "some.db").query("SELECT count(*) FROM ranked_effect WHERE number = 0")[0][0]),
            2);
  Database(folder_ / "some.db").execute("UPDATE version SET program = '0.2.0'; DELETE FROM bench_case");
  const ChildOutcome refused = archive({"restore", "some.db", "first.sql.gz"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.errors, testing::HasSubstr("v is of 0.1.0, there of 0.2.0"));
  EXPECT_EQ(integer(Database(folder_ / "some.db").query("SELECT count(*) FROM bench_case")[0][0]), 0);
}

TEST_F(Archive, WhatIsNoDatabaseIsNotKept) {
  folder_.write("note.db",
                "not a database, though longer than the header of one would be: a hundred bytes and more of text");
  const ChildOutcome refused = archive({"keep", "note.db", "note.sql.gz"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.errors, testing::HasSubstr("note.db is no database of the benchmark"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "note.sql.gz"));
}

TEST_F(Archive, NothingIsRestoredWhereOneFileIsMissing) {
  make("first.db", {0});
  ASSERT_EQ(archive({"keep", "first.db", "first.sql.gz"}).code, 0);
  EXPECT_EQ(archive({"restore", "all.db", "first.sql.gz", "second.sql.gz"}).code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "all.db"));
}

}  // namespace
}  // namespace hidden_effects
