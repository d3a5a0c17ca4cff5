#include "eea/ensemble/judges.h"
#include "eea/small_run.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

/// Models that judge tests.
namespace lacuna {
namespace {

TEST(Judges, AreThoseThatDiffer) {
  const auto opened = small_bench(
      {"estimation.restarts=3", "exploration.fitness=model_disagreement", "exploration.fitness_parameters={models=3}"});
  EXPECT_EQ(opened->definition().value.models(), 3U);
  const MemoryJournal journal = run(*opened);
  EXPECT_GT(journal.passes[0].best_fitness, 0.0);
  // Each test is simulated on three models, 30 steps each; the noise takes one simulation more a trial.
  EXPECT_GE(journal.passes[0].test_steps, journal.passes[0].test_evaluations * 3 * 30);
}

/// A state with one trial and the best models of the first pass.
EeaState after_first_pass(const OpenEeaRun& opened) {
  MemoryJournal journal;
  EeaState state = beginning(opened);
  run(opened, journal, state);
  for (const std::vector<double>& checkpoint : journal.checkpoints) {
    EeaState then = state_at(opened, journal, checkpoint);
    if (then.phase == Phase::exploration) return then;
  }
  throw Error("the run never explored");
}

TEST(Judges, KnowTheNoiseOfEachChannel) {
  const auto opened = small_bench({"exploration.fitness=model_disagreement", "estimation.sensors=['sensor.angle*']",
                                   "target.noise.'sensor.angle_front_left'=0.02"});
  const EeaState state = after_first_pass(*opened);
  const Judges judges(opened->definition(), {1}, state);
  std::vector<TestPrediction> predictions(judges.size());
  std::uint64_t steps = 0;
  std::string reason;
  ASSERT_TRUE(judges.predict(state.trials[0].drive, 0, predictions, steps, reason)) << reason;
  ASSERT_EQ(predictions.size(), 2U);
  const std::vector<Channel>& channels = opened->definition().compiled->channels();
  ASSERT_EQ(predictions[0].noise.size(), channels.size());
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const bool is_scored = channels[c].name.starts_with("angle");
    EXPECT_EQ(std::isfinite(predictions[0].noise[c]), is_scored) << channels[c].name;
    if (is_scored) {
      EXPECT_GT(predictions[0].noise[c], 0.0);
    }
  }
  const auto declared = std::find_if(channels.begin(), channels.end(),
                                     [](const Channel& channel) { return channel.name == "angle_front_left"; });
  EXPECT_EQ(predictions[0].noise[static_cast<std::size_t>(declared - channels.begin())], 0.02);
  EXPECT_TRUE(predictions[0].slopes.empty()) << "nobody asked for them";
}

TEST(Judges, SlopesAreWhatAValueOfItsWholeRangeWouldChange) {
  const auto opened = small_bench({"exploration.fitness=model_disagreement",
                                   "exploration.fitness_parameters={refit=1,noise=0.1}", "test.duration=0.1"});
  const EeaState state = after_first_pass(*opened);
  const Judges judges(opened->definition(), {1}, state);
  std::vector<TestPrediction> predictions(judges.size());
  std::uint64_t steps = 0;
  std::string reason;
  ASSERT_TRUE(judges.predict(state.trials[0].drive, 0, predictions, steps, reason)) << reason;
  const std::size_t free = opened->definition().model.free.size();
  ASSERT_EQ(predictions[0].slopes.size(), free);
  EXPECT_EQ(predictions[0].information.rows(), static_cast<Eigen::Index>(free));
  // At least what the range says, more where a trial told something.
  double told = 0.0;
  for (Eigen::Index k = 0; k < predictions[0].information.rows(); ++k) {
    EXPECT_GE(predictions[0].information(k, k), 12.0);
    told += predictions[0].information(k, k) - 12.0;
  }
  EXPECT_GT(told, 0.0);
  // Against two simulations of another width: of a mass, and of a lag, of which only whole steps count.
  const ModelProposal& judge = state.best.front().model;
  const std::vector<FreeValue>& values = opened->definition().model.free;
  const TestPredictor predictor(*opened->definition().compiled, opened->definition().sample_times, {1});
  int lags = 0;
  for (std::size_t k = 0; k < free; ++k) {
    const bool is_lag = values[k].address.ends_with("delay");
    const double range = values[k].upper - values[k].lower;
    const double side = judge.values[k] < values[k].lower + 0.5 * range ? 1.0 : -1.0;
    const double move = side * (is_lag ? 0.01 / range : 1e-3);  // the engine's step is 10 ms
    ModelProposal moved = judge;
    moved.values[k] += move * range;
    TestPrediction there;
    ASSERT_TRUE(predictor.predict(moved, state.trials[0].drive, 0, there, steps, reason)) << reason;
    const TimeSeries::Samples expected = (there.sensors.samples - predictions[0].sensors.samples) / move;
    EXPECT_LT((predictions[0].slopes[k] - expected).cwiseAbs().maxCoeff(),
              1e-9 * (1.0 + expected.cwiseAbs().maxCoeff()))
        << values[k].address;
    if (is_lag && expected.cwiseAbs().maxCoeff() > 0.0) ++lags;
  }
  EXPECT_GT(lags, 0) << "a lag tells something";
}

TEST(Judges, OfTestsThatNeedSlopesNothingIsKnownOnTheTarget) {
  const auto opened = small_bench({"exploration.fitness=information_gain"});
  EXPECT_EQ(opened->definition().value.models(), 1U);
  const MemoryJournal journal = run(*opened);
  for (const TargetTrialRow& row : journal.trial_rows) EXPECT_TRUE(std::isnan(row.measured_fitness));
}

TEST(Judges, BeforeTheFirstTrialAnApproximateModelHasNothingToBeComparedWith) {
  const auto opened =
      small_bench({"model.approximate=true", "exploration.fitness=model_disagreement", "exploration.stop_below=1e9"});
  const MemoryJournal journal = run(*opened);
  EXPECT_EQ(journal.passes[0].number, 0);
  EXPECT_EQ(journal.passes[0].test_evaluations, 0U) << "a random test";
  EXPECT_EQ(journal.passes[0].stopped, "");
  EXPECT_GT(journal.passes[1].test_evaluations, 0U);
}

TEST(TestValue, AddsWeightedFitnesses) {
  const auto opened = small_bench({"exploration.fitness=model_disagreement", "exploration.fitness_parameters={noise=1}",
                                   "exploration.mix=[{fitness='forward_distance',weight=-2.0}]"});
  const TestValue& value = opened->definition().value;
  EXPECT_EQ(value.name(), "model_disagreement + -2 forward_distance");
  EXPECT_EQ(value.models(), 2U);
  std::vector<TestPrediction> predictions(2);
  for (TestPrediction& prediction : predictions) {
    prediction.sensors.samples = TimeSeries::Samples::Zero(1, 1);
    prediction.centre_of_mass.samples = TimeSeries::Samples::Zero(2, 3);
  }
  predictions[1].sensors.samples(0, 0) = 4.0;         // half of 16 nats
  predictions[0].centre_of_mass.samples(1, 0) = 1.5;  // m
  EXPECT_DOUBLE_EQ(value.score({}, predictions), 8.0 - 2.0 * 1.5);
}

}  // namespace
}  // namespace lacuna
