#include "report/text/change_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

TrialComparison trial(const std::string& name, bool held_out, double free_run, double half_second) {
  TrialComparison trial;
  trial.trial = name;
  trial.held_out = held_out;
  trial.channels.resize(1);
  trial.channels[0].channel = "angle";
  trial.channels[0].unit = "rad";
  trial.channels[0].rmse = free_run;
  trial.horizons = {{0.5, false, {half_second}}};
  return trial;
}

RevisionErrors errors(std::vector<TrialComparison> trials) {
  RevisionErrors errors;
  errors.comparison.trials = std::move(trials);
  return errors;
}

const RevisionErrors kBefore = errors({trial("sine.csv", false, 1e-3, 1e-4), trial("chirp.csv", true, 1e-3, 1e-4)});

TEST(ChangeText, SaysNothingOfRisesWhereNothingRose) {
  const RevisionErrors after = errors({trial("sine.csv", false, 9e-4, 1.005e-4), trial("new.csv", false, 1.0, 1.0)});
  EXPECT_THAT(error_rises(kBefore.comparison, after.comparison), IsEmpty());
  EXPECT_THAT(change_text(kBefore, after, "lacuna undo rig.toml"), Not(HasSubstr("undo")));
}

TEST(ChangeText, NamesEachFileAndHorizonWhoseErrorRoseAndHowToTakeItBack) {
  const RevisionErrors after = errors({trial("sine.csv", false, 9e-4, 2e-4), trial("chirp.csv", true, 3e-3, 1e-4)});
  const std::vector<ErrorRise> rises = error_rises(kBefore.comparison, after.comparison);
  ASSERT_THAT(rises, SizeIs(2));
  EXPECT_EQ(rises[0].horizon, 0.5);
  EXPECT_TRUE(rises[1].held_out);
  const std::string text = change_text(kBefore, after, "lacuna undo rig.toml");
  EXPECT_THAT(text, testing::ContainsRegex("angle +sine.csv +0.5 s segments +100 µrad → +200 µrad"));
  EXPECT_THAT(text, testing::ContainsRegex("angle +held out chirp.csv +free run +1.00 mrad → +3.00 mrad"));
  EXPECT_THAT(text, HasSubstr("to undo the change: lacuna undo rig.toml\n"));
  const nlohmann::json document = nlohmann::json::parse(change_json("oil", kBefore, after, "lacuna undo rig.toml"));
  EXPECT_THAT(document["rises"], SizeIs(2));
  EXPECT_EQ(document["undo"], "lacuna undo rig.toml");
}

TEST(ChangeText, SetsErrorsOverEachLengthSideBySide) {
  const auto pooled = [](RevisionErrors revision, double rmse) {
    PooledScore score;
    score.channel = "angle";
    score.unit = "rad";
    score.rmse = rmse;
    revision.comparison.pooled = {score};
    return revision;
  };
  const RevisionErrors before = pooled(errors({trial("sine.csv", false, 1e-3, 2e-4)}), 1e-3);
  const RevisionErrors after = pooled(errors({trial("sine.csv", false, 1e-4, 5e-5)}), 1e-4);
  EXPECT_THAT(change_text(before, after), testing::ContainsRegex(" 0.5 s segments +200 µrad → +50.0 µrad +−75 %"));
}

TEST(ChangeText, NamesAFileThatCannotBeSimulatedAnyMore) {
  TrialComparison failed = trial("sine.csv", false, std::nan(""), std::nan(""));
  failed.valid = false;
  EXPECT_THAT(change_text(kBefore, errors({failed})), HasSubstr("cannot be simulated"));
}

}  // namespace
}  // namespace lacuna
