#include "fitting/comparison.h"

#include "fitting/recorded_spring.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

using namespace lacuna::analytic;
using testing::SizeIs;

Trial from_given_start(Trial trial) {
  trial.initial = {{InitialKnowledge::given, 0.3, -0.2}};
  return trial;
}

Comparison compare_spring(const std::vector<Trial>& trials, double damping) {
  const OneJointModel model(spring);
  const ModelDefinition definition = spring_definition();
  const NoiseSection noise;
  return compare({definition, model, trials, noise, {damping}, nullptr, {0.1, 0.5}, 1, {2}});
}

TEST(Compare, TheRightModelsErrorIsTheFloor) {
  const Comparison comparison = compare_spring({from_given_start(spring_trial(kNoise, 1))}, 0.5);
  const ChannelScore& score = comparison.trials[0].channels[0];
  EXPECT_NEAR(score.rmse, kNoise, 0.08 * kNoise);  // 1001 samples: ±2.2 %
  EXPECT_EQ(score.floor, kNoise);
  EXPECT_EQ(score.times_floor, score.rmse / score.floor);
  EXPECT_EQ(score.samples, 1001u);  // a given start leaves every sample to be scored
  EXPECT_EQ(score.from_start, 0.0);
  EXPECT_EQ(comparison.floors[0].channels[0].origin, "declared for the column");
  EXPECT_GT(score.rmse_as_written, 10 * score.rmse);
}

TEST(Compare, NamesBiasAndWorstMoment) {
  Trial trial = spring_trial(0.0, 1);
  trial.sensor_noise = {kNoise};
  trial = from_given_start(trial);
  trial.measured.samples.array() += 0.01;
  trial.measured.samples(700, 0) += 0.05;
  const ChannelScore score = compare_spring({trial}, 0.5).trials[0].channels[0];
  EXPECT_EQ(score.samples, 1001u);  // a given start leaves every sample to be scored
  EXPECT_NEAR(score.bias, 0.01 + 0.05 / 1001, 1e-12);
  EXPECT_NEAR(score.max_error, 0.06, 1e-12);
  EXPECT_NEAR(score.max_error_time, 3.5, 1e-12);
  EXPECT_NEAR(score.rmse, std::sqrt((1000 * 1e-4 + 0.06 * 0.06) / 1001), 1e-12);
}

TEST(Compare, KeepsFitAndHeldOutApart) {
  std::vector<Trial> trials = {from_given_start(spring_trial(kNoise, 1)), from_given_start(spring_trial(kNoise, 2)),
                               from_given_start(spring_trial(3 * kNoise, 3))};
  trials[2].held_out = true;
  const Comparison comparison = compare_spring(trials, 0.5);
  ASSERT_THAT(comparison.pooled, SizeIs(2));
  EXPECT_FALSE(comparison.pooled[0].held_out);
  EXPECT_EQ(comparison.pooled[0].samples, 2 * 1001u);
  EXPECT_NEAR(comparison.pooled[0].rmse, kNoise, 0.08 * kNoise);
  EXPECT_TRUE(comparison.pooled[1].held_out);
  EXPECT_NEAR(comparison.pooled[1].rmse, 3 * kNoise, 0.25 * kNoise);
  EXPECT_EQ(comparison.pooled[1].floor, kNoise);  // the floor is the fit files'
  EXPECT_EQ(comparison.pooled[1].worst_trial, "trial 3");
}

TEST(Compare, ShortHorizonsForgiveAWrongModelMore) {
  const Comparison comparison = compare_spring({spring_trial(1e-4, 1)}, 0.1);
  const std::vector<HorizonScore>& horizons = comparison.trials[0].horizons;
  ASSERT_GE(horizons.size(), 2u);
  EXPECT_EQ(horizons[0].horizon, 0.1);
  EXPECT_LT(horizons[0].rmse[0], 0.5 * horizons[1].rmse[0]);
  EXPECT_LT(horizons[1].rmse[0], comparison.trials[0].channels[0].rmse);
}

TEST(UsualHorizons, GoFromAFewSamplesToHalfTheLongestTrial) {
  const auto horizons = [](double interval, double duration) {
    Trial trial;
    trial.measured.times =
        Eigen::VectorXd::LinSpaced(1 + static_cast<Eigen::Index>(duration / interval), 0.0, duration);
    trial.measured.samples = TimeSeries::Samples::Zero(trial.measured.times.size(), 1);
    return usual_horizons({trial});
  };
  EXPECT_THAT(horizons(0.002, 4.0), testing::ElementsAre(0.1, 0.5, 2.0));
  EXPECT_THAT(horizons(0.001, 25.0), testing::ElementsAre(0.1, 0.5, 2.0, 10.0));
  EXPECT_THAT(horizons(1.0 / 15.0, 3.0), testing::ElementsAre(0.5));
  EXPECT_THAT(horizons(0.0005, 0.1), testing::IsEmpty());
}

TEST(UsualHorizons, CountWhatWasMeasuredAndNotItsRepeats) {
  Trial trial;
  trial.measured.times = Eigen::VectorXd::LinSpaced(801, 0.0, 4.0);  // logged every 5 ms, measured every 50 ms
  trial.measured.samples = TimeSeries::Samples::Constant(801, 1, std::nan(""));
  for (Eigen::Index row = 0; row < 801; row += 10) trial.measured.samples(row, 0) = 0.0;
  EXPECT_THAT(usual_horizons({trial}), testing::ElementsAre(0.5, 2.0));
}

TEST(Compare, TellsHowLongAStartStaysCertain) {
  const Comparison comparison = compare_spring({spring_trial(kNoise, 1)}, 0.5);
  // A line through N = 11 samples of T = 50 ms is uncertain by σ √(1/N + 12 (t − T/2)²/(N T²)): 2 σ after 0.12 s,
  // a sample or two later under a spring with a damper.
  EXPECT_NEAR(comparison.start_horizon, 0.13, 0.01);
  EXPECT_FALSE(comparison.trials[0].horizons.back().automatic);  // half a second is scored anyway
}

TEST(Compare, GivesPicturesTheirSeries) {
  Trial trial = spring_trial(kNoise, 1);
  trial.measured.samples(500, 0) = std::nan("");
  const TrialComparison comparison = compare_spring({trial}, 0.5).trials[0];
  EXPECT_EQ(comparison.predicted.rows(), 1001);
  EXPECT_TRUE(comparison.predicted.allFinite());
  EXPECT_TRUE(std::isnan(comparison.residuals(500, 0)));
  EXPECT_EQ(comparison.channels[0].samples, 989u);
  EXPECT_EQ(comparison.residuals(3, 0), comparison.measured(3, 0) - comparison.predicted(3, 0));
}

/// The spring, beside a finer model that is pushed by so many rad/s².
Comparison compare_with_pushed(double push, double damping) {
  const OneJointModel model(spring);
  const OneJointModel other(
      [push](std::span<const double> p, double q, double v, double u) { return spring(p, q, v, u) + push; });
  const ModelDefinition definition = spring_definition();
  const NoiseSection noise;
  const std::vector<Trial> trials = {spring_trial(kNoise, 1)};
  return compare({definition, model, trials, noise, {damping}, &other});
}

TEST(Compare, NumericalShareIsTheChangeOfThePrediction) {
  const Comparison comparison = compare_with_pushed(0.01, 0.5);
  // A constant push of 0.01 rad/s² against k = 4 1/s² moves the rest by 2.5 mrad, after an overshoot.
  EXPECT_NEAR(comparison.trials[0].channels[0].numerical.value(), 2.5e-3, 1e-3);
  EXPECT_FALSE(compare_spring({spring_trial(kNoise, 1)}, 0.5).trials[0].channels[0].numerical.has_value());
}

TEST(Compare, AsksForSmallerStepsWhereTheyCount) {
  const auto notes = [](double damping) { return compare_with_pushed(0.05, damping).notes; };
  const std::string asks =
      "the numerical error of angle is not small compared with its error and floor; set more engine.substeps, or 0 for "
      "automatic";
  // 12.5 mrad at rest, beside an error of 10 that the uncertain start makes.
  EXPECT_THAT(notes(0.5), testing::Contains(asks));
  EXPECT_THAT(notes(0.0), testing::Not(testing::Contains(asks)));  // small beside that of a spring without damping
}

/// The spring's model, but for angles beyond 0.6 rad, and a trial on either side.
Comparison compare_spring_that_fails_beyond(bool fails_held_out) {
  const OneJointModel model([](std::span<const double> p, double q, double v, double u) {
    return q > 0.6 ? std::nan("") : spring(p, q, v, u);
  });
  Trial high = spring_trial(kNoise, 2);
  high.measured.samples.array() += 0.8;
  const ModelDefinition definition = spring_definition();
  const NoiseSection noise;
  Trial low = spring_trial(kNoise, 1, 1.0);
  high.held_out = fails_held_out;
  const std::vector<Trial> trials = {low, high};
  return compare({definition, model, trials, noise, {0.5}});
}

TEST(Compare, ATrialThatCannotBeSimulatedIsNamedAndLeavesNoErrorOfAll) {
  const Comparison comparison = compare_spring_that_fails_beyond(false);
  EXPECT_TRUE(comparison.trials[0].valid);
  EXPECT_FALSE(comparison.trials[1].valid);
  ASSERT_THAT(comparison.notes, SizeIs(1));
  EXPECT_THAT(comparison.notes[0], testing::HasSubstr("trial 2 cannot be simulated"));
  EXPECT_EQ(comparison.trials[1].channels[0].samples, 1001u - 11u);  // that it owes a prediction of
  EXPECT_TRUE(std::isnan(comparison.trials[1].channels[0].rmse));
  EXPECT_TRUE(comparison.trials[1].predicted.array().isNaN().all());
  ASSERT_THAT(comparison.pooled, SizeIs(1));
  EXPECT_EQ(comparison.pooled[0].failed_trials, 1);
  EXPECT_TRUE(std::isnan(comparison.pooled[0].rmse));
  EXPECT_TRUE(std::isnan(comparison.pooled[0].times_floor));
  EXPECT_EQ(comparison.pooled[0].samples, comparison.trials[0].channels[0].samples);
}

TEST(Compare, AFailedHeldOutTrialLeavesTheErrorOfTheFitTrials) {
  const Comparison comparison = compare_spring_that_fails_beyond(true);
  ASSERT_THAT(comparison.pooled, SizeIs(2));
  EXPECT_EQ(comparison.pooled[0].failed_trials, 0);
  EXPECT_EQ(comparison.pooled[0].rmse, comparison.trials[0].channels[0].rmse);
  EXPECT_TRUE(comparison.pooled[1].held_out);
  EXPECT_EQ(comparison.pooled[1].failed_trials, 1);
  EXPECT_TRUE(std::isnan(comparison.pooled[1].rmse));
}

TEST(Compare, TheShareOfTheStartIsPooledLikeTheFloor) {
  const Comparison comparison = compare_spring({spring_trial(kNoise, 1), spring_trial(kNoise, 2, 2.5)}, 0.5);
  const ChannelScore& one = comparison.trials[0].channels[0];
  const ChannelScore& two = comparison.trials[1].channels[0];
  const auto samples = [](const ChannelScore& score) { return static_cast<double>(score.samples); };
  const double mean_square =
      (samples(one) * one.from_start * one.from_start + samples(two) * two.from_start * two.from_start) /
      (samples(one) + samples(two));
  EXPECT_NEAR(comparison.pooled[0].from_start, std::sqrt(mean_square), 1e-12);
  EXPECT_NE(one.from_start, two.from_start);
}

TEST(Compare, ATrialThatEndsWithinItsFirst50MillisecondsIsNamed) {
  const Comparison comparison = compare_spring({spring_trial(kNoise, 1, 1.0), spring_trial(kNoise, 2, 0.03)}, 0.5);
  EXPECT_EQ(comparison.trials[1].channels[0].samples, 0u);
  ASSERT_THAT(comparison.notes, SizeIs(1));
  EXPECT_THAT(comparison.notes[0], testing::HasSubstr("trial 2 has no score"));
}

TEST(Compare, NothingToScoreIsNoAgreement) {
  Trial masked = spring_trial(kNoise, 1, 1.0);
  masked.measured.samples.setConstant(std::nan(""));
  EXPECT_THAT([&] { compare_spring({masked}, 0.5); },
              testing::ThrowsMessage<Error>(testing::HasSubstr("nothing to compare: trial 1")));
}

TEST(Compare, GivesTheSameDigitsForAnyNumberOfThreads) {
  const OneJointModel model(spring);
  const ModelDefinition definition = spring_definition();
  const NoiseSection noise;
  std::vector<Trial> trials = {spring_trial(kNoise, 1), spring_trial(kNoise, 2)};
  for (Trial& trial : trials) trial.command_noise = {0.05};
  const Comparison one = compare({definition, model, trials, noise, {0.5}, nullptr, {0.1}, 1, {1}});
  const Comparison two = compare({definition, model, trials, noise, {0.5}, nullptr, {0.1}, 1, {2}});
  for (std::size_t t = 0; t < 2; ++t) {
    EXPECT_EQ(one.trials[t].channels[0].rmse, two.trials[t].channels[0].rmse);
    EXPECT_EQ(one.trials[t].channels[0].floor, two.trials[t].channels[0].floor);
    EXPECT_EQ(one.trials[t].horizons[0].rmse, two.trials[t].horizons[0].rmse);
  }
}

/// A spring that swings from the first sample to the last, in whose recording nothing shows the noise alone.
TEST(Compare, SaysWhereToDeclareANoiseThatIsAGuess) {
  Trial trial = from_given_start(spring_trial(kNoise, 1));
  EXPECT_THAT(compare_spring({trial}, 0.5).notes,
              testing::Not(testing::Contains(testing::HasSubstr("noise is estimated"))));
  trial.sensor_noise.clear();
  EXPECT_THAT(compare_spring({trial}, 0.5).notes,
              testing::Contains(
                  testing::AllOf(testing::HasSubstr("noise is estimated from readings in motion"),
                                 testing::HasSubstr("under [target.sensors], as in angle = { ..., noise = \"0.00"))));
}

}  // namespace
}  // namespace lacuna
