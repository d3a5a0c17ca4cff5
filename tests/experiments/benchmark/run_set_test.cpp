#include "runs/run_set.h"

#include "runs/case_failure.h"
#include "runs/case_store.h"
#include "runs/user_session.h"
#include "runs/work_folder.h"

#include "experiments/benchmark/small_results.h"
#include "support/test_folder.h"

#include <gmock/gmock.h>

#include <atomic>

namespace hidden_effects {
namespace {

class RunSet : public testing::Test {
 protected:
  RunSet() : database_(folder_ / "benchmark.db") {
    keep_version(database_, "v", "0.1.0");
    for (int number = 0; number < 6; ++number) {
      CasePlan plan;
      plan.set = "tuning";
      plan.number = number;
      plans_.push_back(plan);
    }
  }

  SetProgress run(const RunOne& run_one, int jobs = 1, bool again = false) {
    return run_set(
        database_, "v", plans_, jobs, again, run_one, [this] { return stop_.load(); },
        [](const CaseResult&, const SetProgress&) {});
  }

  std::int64_t rows(const std::string& table) {
    return integer(database_.query("SELECT count(*) FROM " + table)[0][0]);
  }

  /// A case with something in every table that a run fills.
  static CaseResult whole(const CasePlan& plan) {
    CaseResult result = small_case(plan.number, "one_joint", {kCoulomb});
    result.diagnoses = {small_diagnosis(1, "effect_found", 0.9, {kCoulomb}, {kStribeck})};
    result.diagnoses[0].added = {kCoulomb};
    result.held_out = {{"base", "angle", 0.1}};
    result.free_values = {{{"body.arm.mass", 1.0, 0.9, 1.1}, 1.0}};
    result.settling = {kCoulomb, kStribeck, "", {{"chosen", {{"a line", "effect_found", 1.0}}, kCoulomb, ""}}};
    return result;
  }

  lacuna::TestFolder folder_;
  Database database_;
  std::vector<CasePlan> plans_;
  std::atomic<bool> stop_ = false;
};

TEST_F(RunSet, KeepsEveryCaseOnce) {
  std::atomic<int> calls = 0;
  const RunOne one = [&](const CasePlan& plan) {
    ++calls;
    return whole(plan);
  };
  EXPECT_EQ(run(one, 3).kept, 6);
  const SetProgress again = run(one, 3);
  EXPECT_EQ(again.kept, 0);
  EXPECT_EQ(again.before, 6);
  EXPECT_EQ(calls, 6);
  for (const char* table : {"bench_case", "hidden_law", "hidden_value", "diagnosis", "ranked_model", "added_effect",
                            "settling", "settling_run", "settling_test"})
    EXPECT_EQ(rows(table), 6) << table;
  EXPECT_EQ(rows("ranked_effect"), 12);
  EXPECT_EQ(rows("interval"), 12);
}

TEST_F(RunSet, GoesOnWhereItWasStopped) {
  const SetProgress first = run([&](const CasePlan& plan) {
    if (plan.number == 2) {
      stop_ = true;
      throw CaseStopped();
    }
    return whole(plan);
  });
  EXPECT_TRUE(first.stopped);
  EXPECT_EQ(rows("bench_case"), 2);
  stop_ = false;
  const SetProgress second = run(whole);
  EXPECT_EQ(second.kept, 4);
  EXPECT_FALSE(second.stopped);
  EXPECT_EQ(rows("bench_case"), 6);
}

/// The second diagnosis has the first one's key.
TEST_F(RunSet, KeepsNothingOfACaseThatCannotBeKeptWhole) {
  EXPECT_THROW(run([](const CasePlan& plan) {
                 CaseResult result = whole(plan);
                 result.diagnoses.push_back(result.diagnoses.front());
                 return result;
               }),
               std::runtime_error);
  EXPECT_EQ(rows("bench_case"), 0);
  EXPECT_EQ(rows("diagnosis"), 0);
}

TEST_F(RunSet, CasesThatEndedEarlyAreRunAgainWhenAskedFor) {
  const SetProgress first = run([](const CasePlan& plan) {
    CaseResult result = whole(plan);
    if (plan.number == 2) result.failure = "lacuna diagnose took longer than 1 s";
    return result;
  });
  EXPECT_EQ(first.failed, 1);
  EXPECT_EQ(run(whole).kept, 0);
  EXPECT_EQ(run(whole, 1, true).kept, 1);
  EXPECT_FALSE(ended_early(database_, "v", "tuning", 2));
  EXPECT_EQ(rows("interval"), 12) << "nothing of the first try is left";
}

TEST(WorkFolder, BelongsToOneRun) {
  const lacuna::TestFolder folder;
  {
    const WorkFolder one(folder / "a/b");
    EXPECT_THROW(WorkFolder(folder / "a/b"), std::invalid_argument);
    const WorkFolder other(folder / "a/c");
  }
  EXPECT_NO_THROW(WorkFolder(folder / "a/b"));
  EXPECT_THROW(WorkFolder(folder.write("file", "x")), std::invalid_argument);
}

TEST_F(RunSet, AnotherVersionHasCasesOfItsOwn) {
  run(whole);
  EXPECT_FALSE(has_case(database_, "w", "tuning", 0));
  EXPECT_TRUE(has_case(database_, "v", "tuning", 0));
}

TEST(BenchmarkDatabase, ThatLacksTablesIsRefusedAndLeftAsItIs) {
  const lacuna::TestFolder folder;
  const std::filesystem::path file = folder / "benchmark.db";
  Database(file).execute("DROP TABLE settling_test; DROP TABLE interval");
  for (const Access access : {Access::write, Access::read})
    EXPECT_THAT([&] { Database again(file, access); },
                testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("interval, settling_test")))
        << "the first did not make them";
}

TEST(BenchmarkDatabase, IsNotMadeByAReader) {
  const lacuna::TestFolder folder;
  EXPECT_THROW(Database(folder / "none.db", Access::read), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(folder / "none.db"));
}

TEST(BenchmarkDatabase, IsNoOtherProgramsFile) {
  const lacuna::TestFolder folder;
  EXPECT_THROW(Database(folder.write("other.db", "this is no database, and long enough to be looked at")),
               std::invalid_argument);
}

}  // namespace
}  // namespace hidden_effects
