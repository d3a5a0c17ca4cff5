#include "figures/withheld_table.h"

#include "dirty/dirty_plan.h"
#include "experiments/benchmark/small_results.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace hidden_effects {
namespace {

using testing::HasSubstr;

/// Number of the first case of the set of which this is true.
int first_case(bool withheld, bool disturbed) {
  const std::vector<dirty::DirtyPlan> plans = dirty::plan_dirty_cases("dirty-withheld");
  return std::find_if(plans.begin(), plans.end(),
                      [&](const dirty::DirtyPlan& plan) {
                        return plan.withheld == withheld && (plan.disturbance > 0.0) == disturbed;
                      })
      ->number;
}

CaseResult result_of(bool withheld, const std::string& verdict, const std::string& goes_with) {
  CaseResult result = small_case(first_case(withheld, false), "free_pendulum", {}, 10.0);
  result.about.set = "dirty-withheld";
  result.dirty = {{"smooth_dry_friction", kCoulomb, "main", false, 0.9, {"coulomb_friction @ joint.hinge"}, {}}};
  result.diagnoses = {small_diagnosis(1, verdict, kUnknown, {kCoulomb}, {})};
  result.diagnoses.front().json =
      goes_with.empty() ? "{}" : fmt::format(R"({{"unexplained": {{"depends_on": "{}"}}}})", goes_with);
  return result;
}

TEST(WithheldTable, ALawThatIsToldAndNamedIsRecognised) {
  const ForceVerdict verdict = force_verdict_of(result_of(true, "not_in_library", "velocity"));
  EXPECT_TRUE(verdict.withheld);
  EXPECT_FALSE(verdict.disturbed);
  EXPECT_TRUE(verdict.ended);
  EXPECT_TRUE(verdict.told);
  EXPECT_TRUE(verdict.named);
}

TEST(WithheldTable, AnotherQuantityIsNotNamed) {
  const ForceVerdict verdict = force_verdict_of(result_of(true, "effect_found", "time"));
  EXPECT_FALSE(verdict.ended);
  EXPECT_TRUE(verdict.told);
  EXPECT_FALSE(verdict.named);
}

TEST(WithheldTable, NothingToldIsNothingRecognised) {
  const ForceVerdict verdict = force_verdict_of(result_of(true, "effect_found", ""));
  EXPECT_FALSE(verdict.told);
  EXPECT_FALSE(verdict.named);
}

TEST(WithheldTable, CountsByWhetherTheLibraryHasTheLaw) {
  const std::string text =
      withheld_tables({result_of(true, "not_in_library", "velocity"), result_of(true, "effect_found", "time"),
                       result_of(false, "effect_found", "")});
  EXPECT_THAT(text, HasSubstr("| withheld | 2 | 2 | 1 | 1 |"));
  EXPECT_THAT(text, HasSubstr("| in the library | 1 | 0 | 0 | 0 | 1 |"));
}

}  // namespace
}  // namespace hidden_effects
