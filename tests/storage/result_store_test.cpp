#include "storage/small_database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lacuna {
namespace {

using test::fill_small_database;
using test::friction;
using test::revision_with;
using test::SmallDatabase;
using testing::ElementsAre;

class ResultStoreTest : public testing::Test {
 protected:
  void begin() { store_.begin_run({.command = "lacuna fit", .seed = 7, .threads = 1}, provenance_of_this_program()); }
  ExperimentId experiment() { return store_.record_experiment({"rig", "rig.toml", "text", {}}); }

  TestFolder folder_;
  Database database_ = Database::open(folder_ / "rig.db");
  ResultStore store_{database_};
};

TEST_F(ResultStoreTest, NothingIsRecordedBeforeARunBegins) {
  EXPECT_THROW(store_.record_experiment({"rig", "rig.toml", "text", {}}), Error);
}

TEST_F(ResultStoreTest, KeysCarryTheRunInTheirUpperBits) {
  begin();
  const ExperimentId first = experiment();
  EXPECT_EQ(first.value, (std::int64_t{1} << 40) + 1);
  begin();
  const ExperimentId second = store_.record_experiment({"other", "other.toml", "text", {}});
  EXPECT_EQ(second.value, (std::int64_t{2} << 40) + 1);
}

TEST_F(ResultStoreTest, AnExperimentIsFoundByNameWhenItsTextChanges) {
  begin();
  const ExperimentId first = experiment();
  EXPECT_EQ(store_.record_experiment({"rig", "rig.toml", "another text", {}}), first);
  EXPECT_EQ(store_.find_experiment("rig"), first);
  EXPECT_EQ(store_.find_experiment("unheard of"), std::nullopt);
}

TEST_F(ResultStoreTest, TheSameModelIsTheSameRevisionWhateverTheOrderOfItsEffects) {
  begin();
  const ExperimentId rig = experiment();
  const StoredRevision one = store_.find_or_add_revision(rig, revision_with({friction("a"), friction("b")}));
  const StoredRevision two = store_.find_or_add_revision(rig, revision_with({friction("b"), friction("a")}));
  EXPECT_FALSE(one.found);
  EXPECT_TRUE(two.found);
  EXPECT_EQ(one.id, two.id);
}

TEST_F(ResultStoreTest, ARevisionKnowsItsParentAndWhatChanged) {
  begin();
  const ExperimentId rig = experiment();
  const StoredRevision rigid = store_.find_or_add_revision(rig, revision_with({}));
  EXPECT_EQ(rigid.number, 1);
  EXPECT_EQ(rigid.parent, std::nullopt);
  EXPECT_EQ(rigid.change, "rigid");

  const StoredRevision added = store_.find_or_add_revision(rig, revision_with({friction("viscous_friction")}));
  EXPECT_EQ(added.number, 2);
  EXPECT_EQ(added.parent, 1);
  EXPECT_EQ(added.change, "viscous_friction");

  RevisionRecord finer = revision_with({friction("viscous_friction")});
  finer.engine.step = 0.0005;
  EXPECT_EQ(store_.find_or_add_revision(rig, finer).change, "other engine");
  EXPECT_EQ(store_.find_or_add_revision(rig, revision_with({})).number, 1) << "found again after an undo";

  const StoredRevision other = store_.find_or_add_revision(rig, revision_with({friction("coulomb_friction")}));
  EXPECT_EQ(other.parent, 1) << "the parent is the one used last, not the one with the largest number";
  const StoredRevision swapped = store_.find_or_add_revision(rig, revision_with({friction("stribeck_friction")}));
  EXPECT_EQ(swapped.change, "stribeck_friction, without coulomb_friction");
}

TEST_F(ResultStoreTest, ARevisionThatAnEarlierRunLeftUnfittedIsNobodysParentAndSaysSo) {
  begin();
  const ExperimentId rig = experiment();
  store_.record_fit(store_.find_or_add_revision(rig, revision_with({})).id, {});
  begin();
  store_.find_or_add_revision(rig, revision_with({friction("viscous_friction")}));  // and was interrupted
  begin();
  EXPECT_EQ(store_.find_or_add_revision(rig, revision_with({friction("coulomb_friction")})).parent, 1);
  const std::vector<HistoryRow> rows = store_.history(rig);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_TRUE(rows[0].fitted);
  EXPECT_FALSE(rows[1].fitted);
}

TEST_F(ResultStoreTest, ARevisionReadsBackAsItWasWritten) {
  begin();
  const ExperimentId rig = experiment();
  RevisionRecord record = revision_with({friction("a")});
  record.effects[0].start = {{"torque", 0.1}};
  record.effects[0].fixed = {"torque"};
  record.free[0].upper = kInfinity;
  const StoredRevision stored = store_.find_or_add_revision(rig, record);
  EXPECT_EQ(digest_of(store_.revision_record(stored.id)), digest_of(record));
  EXPECT_EQ(store_.revision_record(stored.id).free[0].upper, kInfinity);
}

TEST_F(ResultStoreTest, AFitReadsBackWithItsValuesAndNaNAsUnknown) {
  begin();
  const RevisionId revision = store_.find_or_add_revision(experiment(), revision_with({})).id;
  FitRecord fit;
  fit.settings = "s";
  fit.method = "free_run";
  fit.loss = "huber";
  fit.residual = 12.5;
  fit.stages = {{"free run", 0.0, 1, 4, 3, 12, true, 1.1, {0.3, kNotKnown}}};
  fit.values = {{"body.arm.mass", "kg", 0.5, 0.1 + 0.2, kNotKnown, kNotKnown, kNotKnown, AtBound::upper, false}};
  fit.covariance = (Eigen::MatrixXd(2, 2) << 1.0, 0.25, 0.25, kNotKnown).finished();
  fit.notes = {"a note"};
  const FitId id = store_.record_fit(revision, fit);

  const std::optional<StoredFit> stored = store_.last_fit_of(revision, "s");
  ASSERT_TRUE(stored.has_value());
  EXPECT_EQ(stored->id, id);
  EXPECT_EQ(stored->record.residual, 12.5);
  ASSERT_EQ(stored->record.stages.size(), 1U);
  EXPECT_EQ(stored->record.stages[0].agreeing, 3);
  EXPECT_EQ(stored->record.stages[0].values[0], 0.3);
  ASSERT_EQ(stored->record.values.size(), 1U);
  EXPECT_EQ(stored->record.values[0].value, 0.1 + 0.2) << "bit for bit";
  EXPECT_TRUE(std::isnan(stored->record.values[0].standard_error));
  EXPECT_EQ(stored->record.values[0].at_bound, AtBound::upper);
  EXPECT_FALSE(stored->record.values[0].identifiable);
  EXPECT_EQ(stored->record.covariance(0, 1), 0.25);
  EXPECT_TRUE(std::isnan(stored->record.covariance(1, 1)));
  EXPECT_THAT(stored->record.notes, ElementsAre("a note"));
  EXPECT_FALSE(store_.last_fit_of(revision, "other settings").has_value());
}

TEST_F(ResultStoreTest, LooksAreCountedOverAllRevisionsAndNeverTakenBack) {
  begin();
  const ExperimentId rig = experiment();
  const RevisionId first = store_.find_or_add_revision(rig, revision_with({})).id;
  const RevisionId second = store_.find_or_add_revision(rig, revision_with({friction("a")})).id;
  EXPECT_EQ(store_.holdout_looks(rig), 0);
  EXPECT_EQ(store_.count_holdout_look(first, "compare"), 1);
  EXPECT_EQ(store_.count_holdout_look(second, "compare"), 2);
  EXPECT_EQ(store_.count_holdout_look(first, "history"), 3);
  EXPECT_EQ(store_.holdout_looks(rig), 3);
}

TEST_F(ResultStoreTest, AComparisonReadsBack) {
  const SmallDatabase small = fill_small_database(store_);
  const std::optional<StoredComparison> stored = store_.latest_comparison(small.rigid, ComparisonKind::refitted);
  ASSERT_TRUE(stored.has_value());
  EXPECT_EQ(stored->id, small.first_comparison);
  EXPECT_EQ(stored->record.look, 1);
  ASSERT_EQ(stored->record.scores.size(), 2U);
  EXPECT_EQ(stored->record.scores[0].trial, small.fit_trial);
  EXPECT_EQ(stored->record.scores[0].rmse, 0.009);
  EXPECT_EQ(stored->record.scores[0].numerical_error, 2e-5);
  ASSERT_EQ(stored->record.floors.size(), 1U);
  EXPECT_TRUE(std::isnan(stored->record.floors[0].input));
  EXPECT_EQ(stored->record.floors[0].origin, "encoder step 2.9/√12");
  EXPECT_EQ(stored->record.seconds, 1.2);
  EXPECT_FALSE(store_.latest_comparison(small.rigid, ComparisonKind::as_written).has_value());
}

TEST_F(ResultStoreTest, HistoryShowsTheErrorByRevisionInUnitsAndMultiplesOfTheFloor) {
  const SmallDatabase small = fill_small_database(store_);
  const std::vector<HistoryRow> rows = store_.history(small.experiment);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].change, "rigid");
  EXPECT_NEAR(rows[0].fit_rmse, 0.009, 1e-15);
  EXPECT_NEAR(rows[0].held_out_rmse, 0.012, 1e-15);
  EXPECT_NEAR(rows[0].times_floor, 12.0, 1e-12);
  EXPECT_FALSE(rows[0].current);
  EXPECT_EQ(rows[1].change, "coulomb_friction");
  EXPECT_EQ(rows[1].parent, 1);
  EXPECT_NEAR(rows[1].times_floor, 1.2, 1e-12);
  EXPECT_TRUE(rows[1].current);
}

TEST_F(ResultStoreTest, HistoryHasTheErrorsOverEachLengthOfTheLatestComparison) {
  const SmallDatabase small = fill_small_database(store_);
  begin();
  for (const double scale : {1.0, 0.5}) {
    ComparisonRecord record = test::comparison_of(small, {}, 3, scale);
    record.fit = std::nullopt;
    for (const bool held_out : {false, true})
      record.scores.push_back({.trial = held_out ? small.held_out_trial : small.fit_trial,
                               .channel = "angle",
                               .unit = "rad",
                               .horizon = 0.5,
                               .rmse = (held_out ? 0.004 : 0.002) * scale});
    store_.record_comparison(small.rigid, record);
  }
  const std::vector<HistoryRow> rows = store_.history(small.experiment);
  ASSERT_EQ(rows[0].horizons.size(), 1U);
  EXPECT_EQ(rows[0].horizons[0].horizon, 0.5);
  EXPECT_NEAR(rows[0].horizons[0].fit_rmse, 0.001, 1e-15);
  EXPECT_NEAR(rows[0].horizons[0].held_out_rmse, 0.002, 1e-15);
  EXPECT_TRUE(rows[1].horizons.empty());
}

TEST_F(ResultStoreTest, AComparisonWithoutHeldOutTrialsKeepsTheEarlierLook) {
  const SmallDatabase small = fill_small_database(store_);
  begin();
  ComparisonRecord fit_only = test::comparison_of(small, {}, 0, 0.5);
  fit_only.fit = std::nullopt;
  fit_only.look = std::nullopt;
  fit_only.scores.pop_back();
  store_.record_comparison(small.rigid, fit_only);
  const std::vector<HistoryRow> rows = store_.history(small.experiment);
  EXPECT_NEAR(rows[0].fit_rmse, 0.0045, 1e-15);
  EXPECT_NEAR(rows[0].held_out_rmse, 0.012, 1e-15);
  EXPECT_EQ(store_.latest_comparison(small.rigid, ComparisonKind::refitted, true)->id, small.first_comparison);
}

/// The scores of the small database, and a trial of 1000 samples without a prediction.
ComparisonRecord with_failed_trial(const SmallDatabase& small, TrialId failed) {
  ComparisonRecord record = test::comparison_of(small, {}, 3, 0.01);
  record.fit = std::nullopt;
  record.scores.push_back({.trial = failed, .channel = "angle", .unit = "rad", .samples = 1000, .floor = 0.5});
  return record;
}

TEST_F(ResultStoreTest, AFailedFitTrialLeavesNoErrorOfTheFitTrials) {
  const SmallDatabase small = fill_small_database(store_);
  begin();
  const TrialId hard =
      store_.find_or_add_trial(small.experiment, {"hard", "h.csv", std::string(64, 'c'), false, 10.0, 1000});
  store_.record_comparison(small.with_friction, with_failed_trial(small, hard));
  const std::vector<HistoryRow> rows = store_.history(small.experiment);
  EXPECT_EQ(rows[0].failed_trials, 0);
  EXPECT_EQ(rows[1].failed_trials, 1);
  EXPECT_TRUE(std::isnan(rows[1].fit_rmse));
  EXPECT_NEAR(rows[1].held_out_rmse, 0.012 * 0.01, 1e-15);
  EXPECT_NEAR(rows[1].floor, 0.001, 1e-15) << "of the trials that were scored";
}

TEST_F(ResultStoreTest, AFailedHeldOutTrialIsNotReplacedByTheFitTrials) {
  const SmallDatabase small = fill_small_database(store_);
  begin();
  const TrialId hard =
      store_.find_or_add_trial(small.experiment, {"hard", "h.csv", std::string(64, 'c'), true, 10.0, 1000});
  store_.record_comparison(small.with_friction, with_failed_trial(small, hard));
  const HistoryRow row = store_.history(small.experiment)[1];
  EXPECT_EQ(row.failed_trials, 1);
  EXPECT_NEAR(row.fit_rmse, 0.009 * 0.01, 1e-15);
  EXPECT_TRUE(std::isnan(row.held_out_rmse));
  EXPECT_TRUE(std::isnan(row.times_floor));
}

TEST_F(ResultStoreTest, ATrialWithoutAValueToScoreIsNoFailure) {
  const SmallDatabase small = fill_small_database(store_);
  begin();
  const TrialId empty =
      store_.find_or_add_trial(small.experiment, {"hard", "h.csv", std::string(64, 'c'), true, 0.03, 3});
  ComparisonRecord record = with_failed_trial(small, empty);
  record.scores.back().samples = 0;
  store_.record_comparison(small.with_friction, record);
  const HistoryRow row = store_.history(small.experiment)[1];
  EXPECT_EQ(row.failed_trials, 0);
  EXPECT_NEAR(row.held_out_rmse, 0.012 * 0.01, 1e-15);
}

TEST_F(ResultStoreTest, AFloorThatIsNotKnownOfOneTrialIsNotKnownOfThemAll) {
  const SmallDatabase small = fill_small_database(store_);
  begin();
  const TrialId other =
      store_.find_or_add_trial(small.experiment, {"hard", "h.csv", std::string(64, 'c'), true, 10.0, 1000});
  ComparisonRecord record = with_failed_trial(small, other);
  record.scores.back().rmse = 0.012 * 0.01;
  record.scores.back().floor = kNotKnown;
  store_.record_comparison(small.with_friction, record);
  const HistoryRow row = store_.history(small.experiment)[1];
  EXPECT_NEAR(row.held_out_rmse, 0.012 * 0.01, 1e-15);
  EXPECT_TRUE(std::isnan(row.times_floor));
}

TEST_F(ResultStoreTest, ARevisionThatWasNeverComparedStandsInHistoryWithoutErrors) {
  begin();
  const ExperimentId rig = experiment();
  store_.find_or_add_revision(rig, revision_with({}));
  const std::vector<HistoryRow> rows = store_.history(rig);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_TRUE(std::isnan(rows[0].fit_rmse));
  EXPECT_TRUE(rows[0].channel.empty());
}

TEST_F(ResultStoreTest, TracesOfTrialsAreStoredOnce) {
  begin();
  const TrialId trial =
      store_.find_or_add_trial(experiment(), {"sine", "sine.csv", test::kSomeDigest, false, 1.0, 100});
  const TraceId first = store_.record_trace(trial, TraceKind::measured, test::sine(100), TracePrecision::float64);
  EXPECT_EQ(store_.record_trace(trial, TraceKind::measured, test::sine(100), TracePrecision::float64), first);
  EXPECT_EQ(store_.find_trace(trial, TraceKind::measured), first);
  EXPECT_EQ(store_.find_trace(trial, TraceKind::commands), std::nullopt);
  EXPECT_TRUE(store_.trace(first).samples == test::sine(100).samples);
}

TEST_F(ResultStoreTest, AFlippedBitInATraceIsNoticed) {
  begin();
  const TrialId trial =
      store_.find_or_add_trial(experiment(), {"sine", "sine.csv", test::kSomeDigest, false, 1.0, 100});
  const TraceId trace = store_.record_trace(trial, TraceKind::measured, test::sine(100));
  database_.execute("UPDATE trace SET samples = CAST(x'01' || substr(samples, 2) AS BLOB)");
  EXPECT_THROW(store_.trace(trace), Error);
}

TEST_F(ResultStoreTest, WhatIsNotCommittedIsNotThere) {
  begin();
  {
    Transaction transaction(database_);
    experiment();
  }
  EXPECT_EQ(store_.find_experiment("rig"), std::nullopt);
}

TEST_F(ResultStoreTest, ARunThatIsNotEndedIsStoredAsFailed) {
  {
    ResultStore abandoned(database_);
    abandoned.begin_run({.command = "lacuna fit", .seed = 1, .threads = 1}, provenance_of_this_program());
  }
  begin();
  EXPECT_NO_THROW(
      database_.execute("CREATE TEMP TABLE expect (failed INTEGER CHECK (failed = 1)); INSERT INTO expect "
                        "SELECT count(*) FROM run WHERE ending = 'failed'"));
}

TEST_F(ResultStoreTest, ADiagnosisIsFoundByRevisionAndSettings) {
  const SmallDatabase small = fill_small_database(store_);
  EXPECT_EQ(store_.diagnosis_of(small.rigid, "all effects"), test::found_friction().document);
  EXPECT_EQ(store_.diagnosis_of(small.rigid, "some effects"), std::nullopt);
  EXPECT_EQ(store_.diagnosis_of(small.with_friction, "all effects"), std::nullopt);
}

TEST_F(ResultStoreTest, ADiagnosisThatTwoProcessesMakeIsStoredOnce) {
  const SmallDatabase small = fill_small_database(store_);
  const DiagnosisId first = store_.record_diagnosis(small.with_friction, test::found_friction());
  EXPECT_EQ(store_.record_diagnosis(small.with_friction, test::found_friction()), first);
  EXPECT_NO_THROW(
      database_.execute("CREATE TEMP TABLE expect (two INTEGER CHECK (two = 2)); INSERT INTO expect "
                        "SELECT count(*) FROM diagnosis"))
      << "one of each revision";
}

TEST_F(ResultStoreTest, AStoppedDiagnosisLeavesWhatIsKeptToGoOnFrom) {
  const SmallDatabase small = fill_small_database(store_);
  store_.keep_unfinished_diagnosis(small.with_friction, "all effects", "{}");
  DiagnosisRecord stopped = test::found_friction();
  stopped.settings = "all effects, stopped";
  stopped.document = R"({"stopped": {"during": "screening"}})";
  const DiagnosisId first = store_.record_stopped_diagnosis(small.with_friction, stopped);
  EXPECT_NE(store_.record_stopped_diagnosis(small.with_friction, stopped), first) << "each knows more";
  EXPECT_EQ(store_.unfinished_diagnosis_of(small.with_friction, "all effects"), "{}");
  EXPECT_EQ(store_.diagnosis_of(small.with_friction, "all effects"), std::nullopt);
  EXPECT_NO_THROW(
      database_.execute("CREATE TEMP TABLE expect (two INTEGER CHECK (two = 2)); INSERT INTO expect "
                        "SELECT count(*) FROM diagnoses WHERE stopped = 'screening'"));
}

TEST_F(ResultStoreTest, KnowsWhatTheNearestDiagnosisFoundForAnEffect) {
  const SmallDatabase small = fill_small_database(store_);
  const auto torque = [&](RevisionId revision) {
    const std::vector<CandidateValueRecord> found =
        store_.diagnosed_values(revision, "coulomb_friction", "joint.hinge");
    return found.size() == 1 && found.front().name == "torque" ? found.front().value : -1.0;
  };
  EXPECT_EQ(torque(small.rigid), 0.131);
  EXPECT_EQ(torque(small.with_friction), 0.131) << "of the revision that it was made from";
  DiagnosisRecord again = test::found_friction();
  again.candidates.front().values.front().value = 0.14;
  begin();
  store_.record_diagnosis(small.with_friction, again);
  EXPECT_EQ(torque(small.with_friction), 0.14);
  EXPECT_EQ(torque(small.rigid), 0.131);
  EXPECT_THAT(store_.diagnosed_values(small.rigid, "coulomb_friction", "joint.wrist"), testing::IsEmpty());
  EXPECT_THAT(store_.diagnosed_values(small.rigid, "backlash", "joint.hinge"), testing::IsEmpty());
}

}  // namespace
}  // namespace lacuna
