#include "measured_rigs/rig_results.h"
#include "support/test_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace hidden_effects {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr double kHangs = 300.0;  ///< s, beside other tests

/// All that is accepted is named, and one effect more at most, with which it does not count as right.
void expect_what_it_needs_and_one_more(const AcceptedAnswer& accepted, const RigResult& result) {
  ASSERT_FALSE(result.diagnosis->ranking.empty());
  const std::vector<RankedEffectRecord>& named = result.diagnosis->ranking.front().effects;
  EXPECT_LE(named.size(), accepted.needs.size() + 1);
  for (const Alternatives& wanted : accepted.needs)
    EXPECT_TRUE(std::any_of(named.begin(), named.end(), [&](const RankedEffectRecord& one) {
      return std::find(wanted.begin(), wanted.end(), one.what.effect) != wanted.end();
    })) << wanted.front();
}

/// Two short ones of the fifteen; `lacuna-benchmark real` takes all.
TEST(MeasuredRigs, AreDiagnosedRightAndNotTwice) {
  if (!std::getenv("LACUNA_DATA")) GTEST_SKIP() << "LACUNA_DATA is not set";
  const fs::path source = LACUNA_SOURCE_DIRECTORY;
  const lacuna::TestFolder folder;
  fs::copy(source / "experiments/real", folder.path(), fs::copy_options::recursive);
  ProgramSettings settings;
  settings.lacuna = LACUNA_BINARY_DIRECTORY "/bin/lacuna";
  settings.longest = kHangs;
  const std::vector<AcceptedAnswer> answers =
      read_accepted_answers(source / "experiments/benchmark/measured_rigs/answers.toml");
  std::vector<RigResult> results;
  for (const AcceptedAnswer& one : answers)
    for (const std::string file : {"single-pendulum.toml", "tennis-ball-drop.toml"}) {
      const auto has = [&](const std::vector<std::string>& files) {
        return std::find(files.begin(), files.end(), file) != files.end();
      };
      if (!has(one.experiments) && !has(one.nothing_missing)) continue;
      results.push_back(run_rig(one, file, folder.path(), settings, "test"));
      ASSERT_TRUE(results.back().diagnosis) << results.back().failure;
      if (file == "tennis-ball-drop.toml")
        EXPECT_EQ(grade(one, file, *results.back().diagnosis), Grade::right);
      else
        expect_what_it_needs_and_one_more(one, results.back());
    }
  ASSERT_EQ(results.size(), 2U);
  EXPECT_THAT(table_of(results), testing::AnyOf(HasSubstr("1 of 2 rigs right"), HasSubstr("2 of 2 rigs right")));
  const RigResult again =
      run_rig(*results.front().accepted, results.front().experiment, folder.path(), {.lacuna = "/nowhere"}, "test");
  EXPECT_EQ(again.seconds, results.front().seconds) << "what was done is taken as it is";
}

}  // namespace
}  // namespace hidden_effects
