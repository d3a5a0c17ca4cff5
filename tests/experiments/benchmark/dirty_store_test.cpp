#include "runs/dirty_store.h"

#include "experiments/benchmark/small_results.h"
#include "runs/case_store.h"
#include "runs/dirty_truth.h"
#include "support/test_folder.h"

#include <gtest/gtest.h>

namespace hidden_effects {
namespace {

constexpr const char* kAnswer = R"({"verdict": "nothing_missing", "probability": 0.8, "p_by_chance": 0.5, "seconds": 2,
    "values": {}, "base": {"ratio_to_floor": 1}, "ranking": []})";

CaseResult dirty_result(int number) {
  CaseResult result = small_case(number, "falling_body", {}, 12.0);
  result.about.set = "dirty-quick";
  result.about.rig = "falling_body";
  result.dirty = {{"rough_drag",
                   {"quadratic_drag", "body.body"},
                   "main",
                   false,
                   0.97,
                   {"quadratic_drag @ body.body"},
                   {{"area", 0.01}}}};
  return result;
}

TEST(DirtyStore, KeepsWhatIsReallyThere) {
  const lacuna::TestFolder folder;
  Database database(folder / "dirty.db");
  make_dirty_table(database);
  make_dirty_table(database);  // a second call of `run`
  keep_version(database, "v", "program");
  CaseResult told = dirty_result(4);
  told.diagnoses = {small_diagnosis(1, "nothing_missing", 0.8)};
  told.diagnoses.front().json = kAnswer;
  told.diagnoses.front().processor_seconds = 3.0;
  keep_case(database, told);
  CaseResult failed = dirty_result(2);
  failed.failure = "lacuna diagnose took longer than 5 s";
  keep_case(database, failed);

  const std::vector<CaseResult> read = read_dirty_results(database, "v", "dirty-quick");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].about.number, 2);
  EXPECT_EQ(read[0].failure, failed.failure);
  EXPECT_TRUE(read[0].diagnoses.empty());
  EXPECT_EQ(read[1].about.rig, "falling_body");
  EXPECT_EQ(read[1].about.strength, 12.0);
  EXPECT_EQ(read[1].diagnoses.at(0).verdict, "nothing_missing");
  EXPECT_EQ(read[1].diagnoses.at(0).processor_seconds, 3.0);
  ASSERT_EQ(read[1].dirty.size(), 1U);
  EXPECT_EQ(read[1].dirty[0].answer, (EffectAt{"quadratic_drag", "body.body"}));
  EXPECT_FALSE(read[1].dirty[0].library_form);
  EXPECT_EQ(read[1].dirty[0].share, 0.97);
  EXPECT_EQ(read[1].dirty[0].accepted, std::vector<std::string>{"quadratic_drag @ body.body"});
}

TEST(DirtyStore, CasesAreSelectedLikeOthers) {
  const std::vector<CasePlan> plans = dirty_case_plans("dirty-quick");
  ASSERT_EQ(plans.size(), 60U);
  EXPECT_EQ(plans[7].name(), "dirty-quick-0007");
  EXPECT_EQ(dirty_plan_of(plans[7]).seed, plans[7].seed);
  EXPECT_EQ(dirty_plan_of(plans[7]).family, plans[7].rig);
}

TEST(DirtyTruth, IsWrittenForReading) {
  const dirty::DirtyCase made = dirty::make_dirty_case(dirty_plan_of(dirty_case_plans("dirty-quick")[3]));
  const std::string json = dirty_truth_json(made);
  for (const char* key : {"\"family\": \"falling_body\"", "\"share\"", "\"accepted\"", "\"lasting_time\"", "\"role\""})
    EXPECT_NE(json.find(key), std::string::npos) << key;
  EXPECT_EQ(about_dirty_case(made, dirty_case_plans("dirty-quick")[3], "v").hidden.size(), 1U);
}

}  // namespace
}  // namespace hidden_effects
