#include "runs/settle.h"

#include "hand_made_case.h"

#include "experiments/benchmark/small_results.h"
#include "support/test_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hidden_effects {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A program whose diagnosis after N tests of a choice is CHOICE-N.json; none-0.json before any, open-N.json where
/// there is none for the choice.
constexpr const char* kSettlingProgram = R"(#!/bin/sh
answers=$(dirname "$0")
choice=$(basename "$PWD")
case "$1" in
  trial) cp "$answers/commands.csv" commands.csv ;;
  diagnose)
    n=$(ls test_*.csv 2>/dev/null | wc -l)
    [ ! -e "$answers/refused-$choice" ] || { echo "lacuna: no" >&2; exit 1; }
    file="$answers/$choice-$n.json"
    [ -e "$file" ] || file="$answers/open.json"
    cp "$file" result.json ;;
esac
)";

constexpr const char* kFirstLine = "steps motor 0.1 N*m 1 Hz 0.5 s seed 4";
constexpr const char* kSecondLine = "triangle motor 0.1 N*m 2 Hz 0.5 s";

std::string said(const std::string& effect, const std::string& look_alikes, const std::string& next_test) {
  return fmt::format(R"({{"verdict": "effect_found", "probability": 0.9, "p_by_chance": 0.01, "seconds": 2,
      "base": {{"ratio_to_floor": 3}}, "values": {{}}, "next_test": "{}", "ranking": [{{"probability": 0.9, "gain": 10,
      "ratio_to_floor": 1, "class": [{}], "effects": [{{"effect": "{}", "where": "joint.hinge", "parameters": {{}}}}]}}]}})",
                     next_test, look_alikes, effect);
}

class Settle : public testing::Test {
 protected:
  Settle() : made_(pendulum_case({{"coulomb_friction", 0, {0.05}}}, white_noise(), 101)) {
    made_.trials[0].name = "multisine";
    made_.trials[1].name = "steps";
    made_.trials[2].name = "chirp";
    std::filesystem::permissions(folder_.write("lacuna", kSettlingProgram), std::filesystem::perms::owner_all);
    std::string commands = "t [s],motor [N*m]\n";
    for (int k = 0; k <= 100; ++k) commands += fmt::format("{},{}\n", 0.005 * k, k % 20 < 10 ? 0.1 : -0.1);
    folder_.write("commands.csv", commands);
    folder_.write("open.json", said("stribeck_friction", R"("coulomb_friction @ joint.hinge")", ""));
    first_ = small_diagnosis(1, "effect_found", 0.9, {kStribeck}, {kCoulomb});
    first_.next_test = kFirstLine;
  }

  std::optional<SettlingRecord> run() { return settle(made_, first_, folder_ / "case", {folder_ / "lacuna", 60.0}); }

  static std::vector<std::string> lines(const SettlingRun& run) {
    std::vector<std::string> all;
    for (const SettlingTest& test : run.tests) all.push_back(test.line);
    return all;
  }

  lacuna::TestFolder folder_;
  MadeCase made_;
  DiagnosisRecord first_;
};

TEST_F(Settle, CarriesProposalsOutUntilOneOfTheTwoIsNamedAlone) {
  folder_.write("chosen-1.json", said("stribeck_friction", R"("coulomb_friction @ joint.hinge")", kSecondLine));
  folder_.write("chosen-2.json", said("coulomb_friction", "", ""));
  folder_.write("random-1.json", said("stribeck_friction", "", ""));
  const auto record = run();
  ASSERT_TRUE(record.has_value());
  ASSERT_EQ(record->runs.size(), 3U);
  EXPECT_THAT(lines(record->runs[1]), ElementsAre(kFirstLine, kSecondLine));
  EXPECT_EQ(record->runs[1].remaining, kCoulomb);
  EXPECT_EQ(record->runs[2].tests.size(), 1U);
  EXPECT_EQ(record->runs[2].remaining, kStribeck);
  EXPECT_THAT(record->runs[2].tests[0].line, HasSubstr("Hz 0.5 s"));
  EXPECT_THAT(lacuna::read_bytes(folder_ / "case/chosen/rig.toml"),
              HasSubstr(R"("chirp.csv", "test_1.csv", "test_2.csv"])"));
  EXPECT_NE(lacuna::read_bytes(folder_ / "case/chosen/test_1.csv"),
            lacuna::read_bytes(folder_ / "case/chosen/test_2.csv"));
}

TEST_F(Settle, RepeatsTheLastProposalWithOtherSeedsAndGivesUp) {
  const auto record = run();
  ASSERT_TRUE(record.has_value());
  const SettlingRun& chosen = record->runs.at(1);
  EXPECT_EQ(chosen.tests.size(), static_cast<std::size_t>(kMostSettlingTests));
  EXPECT_EQ(chosen.remaining, EffectAt());
  EXPECT_EQ(chosen.tests[0].line, kFirstLine);
  EXPECT_NE(chosen.tests[1].line, kFirstLine);
  EXPECT_THAT(chosen.tests[5].line, HasSubstr("steps motor 0.1 N*m 1 Hz 0.5 s seed "));
  EXPECT_NE(record->runs.at(2).tests[0].line, record->runs.at(2).tests[1].line);
}

TEST_F(Settle, CarriesNothingOutWhereTheTwoAloneNeedNoTest) {
  folder_.write("none-0.json", said("coulomb_friction", "", ""));
  const auto record = run();
  ASSERT_TRUE(record.has_value());
  ASSERT_EQ(record->runs.size(), 1U);
  EXPECT_EQ(record->runs[0].choice, "none");
  EXPECT_EQ(record->runs[0].remaining, kCoulomb);
}

TEST_F(Settle, LeavesOutAnEffectAtTwoPlaces) {
  first_.ranking[0].look_alikes = {{"stribeck_friction", "joint.elbow"}};
  EXPECT_EQ(run().value().left_out, "both are one effect, at two places");
}

TEST_F(Settle, AFailureIsASentenceAndTheOtherTestsGoOn) {
  folder_.write("refused-chosen", "");
  folder_.write("random-1.json", said("stribeck_friction", "", ""));
  const auto record = run();
  ASSERT_TRUE(record.has_value());
  EXPECT_EQ(record->runs.at(1).failure, "lacuna diagnose ended with code 1: lacuna: no");
  EXPECT_EQ(record->runs.at(2).remaining, kStribeck);
}

}  // namespace
}  // namespace hidden_effects
