#include "storage/asked.h"
#include "storage/core/statement.h"
#include "storage/made_up_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <thread>

namespace lacuna {
namespace {

using test::MadeUpDatabase;
using test::MadeUpRun;
using test::sentence_of;
using testing::ElementsAre;
using testing::HasSubstr;

std::uint64_t bits(double number) { return std::bit_cast<std::uint64_t>(number); }

std::vector<std::uint64_t> bits(const std::vector<double>& numbers) {
  std::vector<std::uint64_t> all;
  for (const double number : numbers) all.push_back(bits(number));
  return all;
}

class EeaStoreTest : public testing::Test {
 protected:
  std::int64_t ask(const char* sql) {
    Statement statement(small_.database, sql);
    EXPECT_TRUE(statement.step());
    return statement.integer(0);
  }
  void fill() {
    small_.advance(run_, run_.commits());
    small_.store->end(RunEnding::done);
  }

  TestFolder folder_;
  MadeUpRun run_;
  MadeUpDatabase small_{folder_ / "run.db"};
};

TEST_F(EeaStoreTest, ModelsComeBackWithEveryBit) {
  fill();
  std::mt19937_64 random(2);  // what the third commit was made from: generation 1 of pass 1
  for (int i = 0; i < run_.models; ++i) {
    const ModelRow expected = run_.made_up_model(random, 1, 1, i);
    const std::optional<ModelRow> model = small_.store->model(expected.number);
    ASSERT_TRUE(model);
    EXPECT_EQ(model->number, expected.number);
    EXPECT_EQ(model->pass, 1);
    EXPECT_EQ(model->generation, 1);
    EXPECT_EQ(model->parents, expected.parents);
    EXPECT_EQ(bits(model->genome), bits(expected.genome));
    EXPECT_EQ(model->kind, expected.kind);
    EXPECT_EQ(model->reused, expected.reused);
    EXPECT_EQ(bits(model->score), bits(expected.score));
    EXPECT_EQ(bits(model->trial_scores), bits(expected.trial_scores));
    EXPECT_EQ(model->reason, expected.reason);
  }
  EXPECT_FALSE(small_.store->model(120));
}

TEST_F(EeaStoreTest, ModelsOfAPassComeByNumberWithTheScoresOfItsTrials) {
  fill();
  const std::vector<ModelRow> models = small_.store->models(2);
  ASSERT_EQ(models.size(), 60U);
  for (std::size_t i = 0; i < models.size(); ++i) {
    EXPECT_EQ(models[i].number, 60 + i);
    const std::size_t scored = models[i].kind == ScoreKind::full ? 2 : models[i].reason.empty() ? 1 : 0;
    EXPECT_EQ(models[i].trial_scores.size(), scored) << i;
  }
  EXPECT_TRUE(small_.store->models(3).empty());
}

TEST_F(EeaStoreTest, TestsTrialsAndPassesComeBack) {
  fill();
  std::mt19937_64 random(4);  // pass 2 begins with commit 4
  for (int i = 0; i < run_.tests; ++i) {
    const TestRow expected = run_.made_up_test(random, 2, i);
    const std::optional<TestRow> test = small_.store->test(expected.number);
    ASSERT_TRUE(test);
    EXPECT_EQ(test->pass, 2);
    EXPECT_EQ(test->generation, expected.generation);
    EXPECT_EQ(test->parents, expected.parents);
    EXPECT_EQ(bits(test->genome), bits(expected.genome));
    EXPECT_EQ(test->valid, expected.valid);
    EXPECT_EQ(bits(test->fitness), bits(expected.fitness));
    EXPECT_EQ(test->reason, expected.reason);
  }
  const std::vector<TargetTrialRow> rows = small_.store->trial_rows();
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1].test, 11U);
  EXPECT_TRUE(std::isnan(rows[0].predicted_fitness));
  EXPECT_EQ(rows[1].predicted_fitness, 2.5);
  EXPECT_EQ(rows[1].measured_fitness, 2.0);
  const std::vector<PassRow> passes = small_.store->passes();
  ASSERT_EQ(passes.size(), 2U);
  const PassRow expected = run_.made_up_pass(2);
  EXPECT_EQ(passes[1].best_model, expected.best_model);
  EXPECT_EQ(passes[1].best_test, expected.best_test);
  EXPECT_EQ(passes[1].best_values, expected.best_values);
  EXPECT_EQ(passes[1].steps, expected.steps);
  EXPECT_EQ(passes[1].test_steps, expected.test_steps);
  ASSERT_EQ(passes[1].objective.size(), 2U);
  EXPECT_EQ(passes[1].objective[0].name, "body.*.mass");
  EXPECT_EQ(passes[1].objective[0].value, 0.5);
}

TEST_F(EeaStoreTest, TrialsComeBackWithEverythingThatAModelIsScoredBy) {
  fill();
  const std::vector<Trial> trials = small_.store->trials();
  ASSERT_EQ(trials.size(), 2U);
  const Trial expected = run_.made_up_trial(2);
  EXPECT_EQ(trials[1].name, "run 1, trial 1");
  EXPECT_EQ(digest_of(trials[1]), digest_of(expected));
  EXPECT_TRUE(trials[1].measured.samples == expected.measured.samples);
  EXPECT_TRUE(trials[1].commands.series.samples == expected.commands.series.samples);
  EXPECT_TRUE(trials[1].centre_of_mass.samples == expected.centre_of_mass.samples);
  EXPECT_EQ(trials[1].commands.hold, Hold::first_order);
  EXPECT_EQ(bits(trials[1].initial[0].velocity), bits(-0.0));
  EXPECT_FALSE(trials[1].held_out);
}

TEST_F(EeaStoreTest, PredictionsBelongToTheirModel) {
  fill();
  EXPECT_EQ(ask("SELECT count(*) FROM trace JOIN model ON model.id = trace.model WHERE trace.kind = 'predicted'"
                " AND comparison IS NULL AND precision = 'float32'"),
            2);
  EXPECT_EQ(ask("SELECT count(*) FROM trace WHERE kind = 'centre_of_mass' AND model IS NULL"), 2);
  EXPECT_EQ(ask("SELECT count(*) FROM trace WHERE kind = 'centre_of_mass' AND model IS NOT NULL"), 2);
}

TEST_F(EeaStoreTest, TheRecordOfTheRunComesBackAndIsCheckedWhenItGoesOn) {
  small_.store->begin(run_.record());
  const EeaRunRecord record = small_.store->record();
  EXPECT_EQ(record.metric, "mean_absolute_error");
  EXPECT_EQ(record.fitness, "forward_distance");
  EXPECT_EQ(record.fitness_unit, "m");
  EXPECT_EQ(record.passes, 2);
  EXPECT_THAT(record.model_genes, ElementsAre("body.torso.mass", "sensor.knee.delay"));
  EXPECT_EQ(record.free[1].upper, 0.2);
  EXPECT_EQ(record.truth[0], 2.5);
  EXPECT_TRUE(std::isnan(record.truth[1]));
  small_.store->begin(run_.record());
  EeaRunRecord other = run_.record();
  other.free[0].upper = 8.0;
  EXPECT_THAT(sentence_of([&] { small_.store->begin(other); }), HasSubstr("run 1 was begun with other free values"));
  other = run_.record();
  other.truth[0] = 2.6;
  EXPECT_THAT(sentence_of([&] { small_.store->begin(other); }), HasSubstr("other hidden values"));
}

TEST_F(EeaStoreTest, NothingIsWrittenBeforeACommitAndNothingAfterTheLast) {
  small_.store->begin(run_.record());
  EXPECT_FALSE(small_.store->checkpoint());
  run_.append(*small_.store, 0);
  EXPECT_EQ(ask("SELECT count(*) FROM test"), 0);
  small_.store->commit({{1.0, -0.0, kInfinity}});
  EXPECT_EQ(ask("SELECT count(*) FROM test"), 10);
  EXPECT_EQ(bits(small_.store->checkpoint()->state), bits({1.0, -0.0, kInfinity}));
  run_.append(*small_.store, 1);
  EXPECT_THAT(sentence_of([&] { small_.store->end(RunEnding::done); }), HasSubstr("has to be committed"));
  small_.store->end(RunEnding::interrupted);
  EXPECT_EQ(ask("SELECT count(*) FROM model"), 0);
  EXPECT_EQ(ask("SELECT count(*) FROM run WHERE ending = 'interrupted'"), 1);
}

TEST_F(EeaStoreTest, ACommitThatFailsChangesNothingAndCanBeDoneAgain) {
  small_.advance(run_, 2);
  run_.append(*small_.store, 2);
  small_.database.execute("PRAGMA query_only = ON");
  EXPECT_THAT(sentence_of([&] { small_.store->commit({{3.0}}); }), HasSubstr("run.db: is read-only"));
  small_.database.execute("PRAGMA query_only = OFF");
  EXPECT_EQ(small_.store->checkpoint()->state, std::vector<double>{2.0});
  EXPECT_EQ(ask("SELECT count(*) FROM model"), 20);
  small_.store->commit({{3.0}});
  small_.advance(run_, run_.commits());
  MadeUpDatabase other(folder_ / "other.db");
  other.advance(run_, run_.commits());
  EXPECT_EQ(content_hash(small_.database, small_.run), content_hash(other.database, other.run));
}

TEST_F(EeaStoreTest, ARunThatIsNotEndedIsStoredAsFailedAndCanGoOn) {
  small_.advance(run_, 3);
  small_.store.reset();
  EXPECT_EQ(ask("SELECT count(*) FROM run WHERE ending = 'failed' AND ended IS NOT NULL"), 1);
  ResultStore results(small_.database);
  results.continue_run(small_.run);
  EXPECT_EQ(ask("SELECT count(*) FROM run WHERE ending IS NULL AND ended IS NULL"), 1);
  small_.store.emplace(small_.database, small_.writing, small_.run, small_.experiment);
  small_.advance(run_, run_.commits());
  small_.store->end(RunEnding::done);
  EXPECT_THAT(sentence_of([&] { results.continue_run(small_.run); }), HasSubstr("run 1 is done"));
  EXPECT_THAT(sentence_of([&] { results.continue_run({7}); }), HasSubstr("run 7 does not exist"));
}

TEST_F(EeaStoreTest, ARunThatIsWrittenToHasNotEndedWhateverBeganIt) {
  RunId run;
  {
    ResultStore beginning(small_.database);
    run = beginning.begin_run({.command = "lacuna run", .seed = 4, .threads = 2}, {});
  }
  EXPECT_EQ(ask("SELECT count(*) FROM run WHERE ending = 'failed'"), 1);
  EeaStore store(small_.database, small_.writing, run, small_.experiment);
  store.begin(run_.record());
  EXPECT_EQ(ask("SELECT count(*) FROM run WHERE ending = 'failed'"), 0);
  run_.commit(store, 0);
  store.end(RunEnding::interrupted);
  { ResultStore(small_.database).continue_run(run); }
  EeaStore again(small_.database, small_.writing, run, small_.experiment);
  EXPECT_TRUE(again.checkpoint());
  run_.commit(again, 1);
  EXPECT_EQ(ask("SELECT count(*) FROM run WHERE ending IS NOT NULL"), 0);
}

TEST_F(EeaStoreTest, TwoThatContinueOneRunAreToldApart) {
  small_.advance(run_, 2);
  MadeUpRun made_up;
  EeaStore second(small_.database, small_.writing, small_.run, small_.experiment);
  ASSERT_TRUE(second.checkpoint());
  made_up.commit(*small_.store, 2);
  EXPECT_THAT(sentence_of([&] { made_up.commit(second, 2); }), HasSubstr("run 1 is also continued by another process"));
  made_up.commit(*small_.store, 3);
}

TEST_F(EeaStoreTest, ReplicatesShareADatabaseFromThreadsOfTheirOwn) {
  const RunId second = small_.results.begin_run({.command = "lacuna run", .seed = 4, .threads = 2}, {});
  small_.results.record_experiment({"quadruped", "quadruped.toml", "[experiment]\n", {}});
  EeaStore other(small_.database, small_.writing, second, small_.experiment);
  std::thread thread([&] {
    other.begin(run_.record());
    for (int i = 0; i < run_.commits(); ++i) run_.commit(other, i);
    other.end(RunEnding::done);
  });
  fill();
  thread.join();
  EXPECT_EQ(content_hash(small_.database, small_.run), content_hash(small_.database, second));
  EXPECT_EQ(ask("SELECT count(*) FROM run WHERE ending = 'done'"), 2);
  EXPECT_EQ(other.trials()[0].name, "run 2, trial 0");
}

TEST_F(EeaStoreTest, RecordedTrialsAreSharedByRuns) {
  const auto add = [&](EeaStore& store) {
    store.begin({.metric = "mean_absolute_error"});
    Trial trial = run_.made_up_trial(1);
    trial.name = "sine.csv";
    store.append({.number = 0, .file = "data/sine.csv"}, trial);
    store.commit({});
  };
  add(*small_.store);
  const RunId second = small_.results.begin_run({.command = "lacuna run", .seed = 4, .threads = 2}, {});
  EeaStore other(small_.database, small_.writing, second, small_.experiment);
  add(other);
  EXPECT_EQ(ask("SELECT count(*) FROM trial"), 1);
  EXPECT_EQ(ask("SELECT count(*) FROM trace WHERE kind = 'measured'"), 1);
  EXPECT_EQ(other.trials()[0].name, "sine.csv");
  EXPECT_EQ(other.trial_rows()[0].file, "data/sine.csv");
  EXPECT_FALSE(other.trial_rows()[0].test);
  EXPECT_EQ(content_hash(small_.database, small_.run), content_hash(small_.database, second));
}

TEST_F(EeaStoreTest, AFinishedRunIsReadFromAFileOpenedForReading) {
  fill();
  Database reading = Database::open_read_only(folder_ / "run.db");
  std::mutex mutex;
  const EeaStore store(reading, mutex, small_.run, small_.experiment);
  EXPECT_EQ(store.models(1).size(), 60U);
  EXPECT_EQ(store.passes().size(), 2U);
  EXPECT_EQ(store.record().replicate, 1);
}

TEST_F(EeaStoreTest, DamageIsNoticedWhereNumbersAreGoneOnWith) {
  fill();
  small_.database.execute("UPDATE checkpoint SET state = CAST(x'01' || substr(state, 2) AS BLOB)");
  EXPECT_THAT(sentence_of([&] { small_.store->checkpoint(); }), HasSubstr("checkpoint of run 1 is damaged"));
  small_.database.execute("UPDATE trial_condition SET sensor_noise = '[0.003]'");
  EXPECT_THAT(sentence_of([&] { small_.store->trials(); }), HasSubstr("trial \"run 1, trial 0\" is damaged"));
}

TEST_F(EeaStoreTest, RunsAreListed) {
  EXPECT_TRUE(eea_runs(small_.database).empty());
  small_.advance(run_, 5);
  const std::vector<EeaRunListing> runs = eea_runs(small_.database);
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_EQ(runs[0].experiment, "quadruped");
  EXPECT_EQ(runs[0].ending, "not ended");
  EXPECT_EQ(runs[0].passes_done, 1);
  EXPECT_EQ(runs[0].passes, 2);
  EXPECT_EQ(runs[0].best_score, 0.5);
  EXPECT_EQ(runs[0].models, 60U);
  EXPECT_EQ(runs[0].evaluations, 60U);
  EXPECT_GT(runs[0].seconds, 0.0);
  EXPECT_GT(small_.store->seconds(), 0.0);
}

}  // namespace
}  // namespace lacuna
