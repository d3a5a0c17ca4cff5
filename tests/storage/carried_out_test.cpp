#include "storage/results/carried_out.h"

#include "storage/results/result_store.h"
#include "support/test_folder.h"

#include <lacuna/error.h>

#include <gmock/gmock.h>

namespace lacuna {
namespace {

const std::string kTarget(64, 'a'), kOther(64, 'b');

Trial pendulum_trial(const std::string& name, double angle) {
  Trial trial;
  trial.name = name;
  trial.measured = {
      {{"angle", "rad"}}, Eigen::VectorXd::LinSpaced(3, 0.0, 1.0), TimeSeries::Samples::Constant(3, 1, angle)};
  trial.commands.series = {{{"motor", "N*m"}}, trial.measured.times, TimeSeries::Samples::Constant(3, 1, 0.25)};
  trial.commands.before = {-0.75};
  trial.initial = {{InitialKnowledge::given, 0.1, 0.0}};
  trial.sensor_noise = {1e-3};
  trial.command_noise = {0.0};
  return trial;
}

TEST(CarriedOut, TrialsOfATargetComeBackAsTheyWere) {
  const TestFolder folder;
  const std::filesystem::path file = folder / "rig.db";
  {
    Database database = Database::open(file);
    EXPECT_EQ(count_carried_out(database, "rig"), 0);
    for (const auto& [name, angle, target] :
         {std::tuple{"trial-1", 0.1, kTarget}, {"trial-2", 0.2, kOther}, {"trial-3", 0.3, kTarget}}) {
      ResultStore store(database);
      Transaction transaction(database);
      const RunId run = store.begin_run({"lacuna trial", 1, 1}, provenance_of_this_program());
      const ExperimentId experiment = store.record_experiment({"rig", "rig.toml", "text", {}});
      Trial trial = pendulum_trial(name, angle);
      trial.held_out = angle > 0.25;
      record_carried_out(database, run, experiment, trial, {"steps motor 0.3 N*m 1 Hz 4 s", target});
      store.end_run(RunEnding::done);
      transaction.commit();
    }
    EXPECT_EQ(count_carried_out(database, "rig"), 3);
    EXPECT_EQ(count_carried_out(database, "other"), 0);
  }
  const std::vector<Trial> trials = carried_out_trials(Database::open_read_only(file), "rig", kTarget);
  ASSERT_EQ(trials.size(), 2U);
  EXPECT_EQ(trials[0].name, "trial-1");
  EXPECT_EQ(trials[1].name, "trial-3");
  EXPECT_TRUE(trials[1].held_out && !trials[0].held_out);
  EXPECT_EQ(trials[1].measured.samples, pendulum_trial("", 0.3).measured.samples);
  EXPECT_EQ(trials[1].commands.series.samples, pendulum_trial("", 0.3).commands.series.samples);
  EXPECT_EQ(trials[1].commands.before, std::vector{-0.75});
  EXPECT_EQ(trials[1].initial.front().position, 0.1);
}

TEST(CarriedOut, AnOlderFileThatIsOnlyReadHasNone) {
  const TestFolder folder;
  { Database::open(folder / "old.db", {schema_migrations().front()}); }
  const Database old = Database::open_read_only(folder / "old.db");
  EXPECT_TRUE(carried_out_trials(old, "rig", kTarget).empty());
  EXPECT_EQ(count_carried_out(old, "rig"), 0);
}

}  // namespace
}  // namespace lacuna
