#include "runs/case_loop.h"

#include "experiments/benchmark/small_results.h"
#include "support/test_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hidden_effects {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A program that writes down its calls and answers from files, so that the loop alone is tested: `diagnose` says what
/// is in answer-1.json the first time, in answer-2.json the second time, and so on.
constexpr const char* kProgram = R"(#!/bin/sh
echo "$*" >> calls.txt
case "$1" in
  compare) cp comparison.json result.json ;;
  diagnose)
    n=$(($(cat round.txt 2>/dev/null || echo 0) + 1))
    if [ -e refusal-$n.txt ]; then
      cat refusal-$n.txt >&2; rm refusal-$n.txt; exit 2
    fi
    echo $n > round.txt
    cp answer-$n.json result.json ;;
  plugins) cp effects.json result.json ;;
  add) [ ! -e no-adding ] || { echo "lacuna: cannot add $2" >&2; exit 1; } ;;
esac
)";

std::string answer(const std::string& verdict, const std::string& effects) {
  return R"({"verdict": ")" + verdict + R"(", "probability": 0.9, "p_by_chance": 0.01, "seconds": 2,
      "values": {"body.arm.mass": {"value": 1.0, "ci95": [0.9, 1.1]}},
      "base": {"ratio_to_floor": 3}, "ranking": [{"probability": 0.9, "gain": 10, "ratio_to_floor": 1, "class": [],
      "effects": [)" +
         effects + "]}]}";
}

constexpr const char* kSpringJson = R"({"effect": "joint_spring", "where": "joint.hinge", "parameters": {}})";
constexpr const char* kTiltJson = R"({"effect": "mount_tilt", "where": "world", "parameters": {}})";

class CaseLoop : public testing::Test {
 protected:
  CaseLoop() {
    std::filesystem::permissions(folder_.write("lacuna", kProgram), std::filesystem::perms::owner_all);
    folder_.write("comparison.json", R"({"pooled": [{"channel": "angle", "held_out": true, "failed_trials": 0,
        "rmse": 0.2}]})");
    folder_.write("effects.json", R"({"components": [{"kind": "effect", "name": "joint_spring"},
        {"kind": "metric", "name": "rmse"}, {"kind": "effect", "name": "restitution"},
        {"kind": "effect", "name": "mount_tilt"}]})");
  }

  CaseResult run(const std::vector<std::string>& withheld = {}) {
    const CaseTask task{
        small_case(0, "one_joint", {kSpring}).about, folder_.path(), {{"body.arm.mass", 1.05}}, withheld};
    return go_through(task, {folder_ / "lacuna", 60.0});
  }

  std::string calls() const { return lacuna::read_bytes(folder_ / "calls.txt"); }

  lacuna::TestFolder folder_;
};

TEST_F(CaseLoop, AddsWhatIsFoundUntilNothingIs) {
  folder_.write("answer-1.json", answer("effect_found", kSpringJson));
  folder_.write("answer-2.json", answer("effect_found", std::string(kSpringJson) + "," + kTiltJson));
  folder_.write("answer-3.json", answer("nothing_missing", ""));
  const CaseResult result = run();
  EXPECT_EQ(result.failure, "");
  ASSERT_EQ(result.diagnoses.size(), 3U);
  EXPECT_THAT(result.diagnoses[0].added, ElementsAre(kSpring));
  EXPECT_THAT(result.diagnoses[1].added, ElementsAre(EffectAt{"mount_tilt", "world"}));
  EXPECT_EQ(result.diagnoses[2].round, 3);
  EXPECT_THAT(calls(), HasSubstr("add rig.toml joint_spring --where joint.hinge --json"));
  EXPECT_THAT(calls(), HasSubstr("add rig.toml mount_tilt --json"));
  ASSERT_EQ(result.held_out.size(), 2U);
  EXPECT_EQ(result.held_out[1].stage, "found");
  EXPECT_EQ(result.free_values.at(0).truth, 1.05);
}

TEST_F(CaseLoop, EndsAfterTheLastRoundWithoutAddingMore) {
  for (int round = 1; round <= 4; ++round)
    folder_.write("answer-" + std::to_string(round) + ".json",
                  answer("effect_found",
                         R"({"effect": "e)" + std::to_string(round) + R"(", "where": "world", "parameters": {}})"));
  const CaseResult result = run();
  EXPECT_EQ(result.diagnoses.size(), 3U);
  EXPECT_TRUE(result.diagnoses.back().added.empty());
}

TEST_F(CaseLoop, AFailingProgramIsASentenceBesideWhatWasDone) {
  folder_.write("answer-1.json", answer("effect_found", kSpringJson));
  folder_.write("no-adding", "");
  const CaseResult result = run();
  EXPECT_EQ(result.failure, "lacuna add ended with code 1: lacuna: cannot add rig.toml");
  EXPECT_EQ(result.diagnoses.size(), 1U);
}

TEST_F(CaseLoop, ACrashIsASentence) {
  std::filesystem::permissions(folder_.write("lacuna", "#!/bin/sh\nkill -SEGV $$\n"),
                               std::filesystem::perms::owner_all);
  EXPECT_EQ(run().failure, "lacuna compare crashed with signal 11");
}

TEST_F(CaseLoop, WithholdsEffectsAndThoseThatTheRobotHasNoPlaceFor) {
  folder_.write("refusal-1.txt", "--among restitution: the effect cannot be added to this model; leave it out\n");
  folder_.write("answer-1.json", answer("not_in_library", ""));
  const CaseResult result = run({"joint_spring"});
  EXPECT_EQ(result.failure, "");
  EXPECT_THAT(calls(), HasSubstr("diagnose rig.toml --among restitution mount_tilt --json"));
  EXPECT_THAT(calls(), HasSubstr("diagnose rig.toml --among mount_tilt --json"));
}

}  // namespace
}  // namespace hidden_effects
