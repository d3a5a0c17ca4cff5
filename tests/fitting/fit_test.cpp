#include "fitting/fit.h"

#include "fitting/analytic_models.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

namespace lacuna {
namespace {

using namespace lacuna::analytic;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kGravity = 9.81;
constexpr double kLength = 0.5;
constexpr double kNoise = 1e-3;

/// m l² q'' = u − b q' − c tanh(q'/0.01) − m g l sin q; values: mass, b, c.
double pendulum(std::span<const double> values, double q, double v, double command) {
  const double torque = command - values[1] * v - values[2] * std::tanh(v / 0.01);
  return (torque - values[0] * kGravity * kLength * std::sin(q)) / (values[0] * kLength * kLength);
}

const std::vector<double> kPendulumTruth = {0.8, 0.05, 0.1};

Trial pendulum_trial(double duration, double noise, std::uint64_t seed) {
  const OneJointModel model(pendulum);
  return record(model, kPendulumTruth, regular_times(static_cast<Eigen::Index>(200 * duration) + 1, 200.0),
                two_sines(duration, 1.5), {{0.3}, {0.0}}, noise, seed);
}

ModelDefinition pendulum_definition() {
  return define({free_value("body.arm.mass", 0.5, 0.1, 10.0), free_value("joint.hinge.damping", 0.0, 0.0, 1e4),
                 free_value("joint.hinge.dry_friction", 0.0, 0.0, 1e4)},
                one_joint_robot());
}

FitResult fit_pendulum(const std::vector<Trial>& trials, const FitSection& options = {}, int threads = 2) {
  const OneJointModel model(pendulum);
  const ModelDefinition definition = pendulum_definition();
  return fit({definition, model, trials, options, 1, {threads}});
}

void expect_truth(const FitResult& result, double tolerance) {
  for (std::size_t i = 0; i < kPendulumTruth.size(); ++i)
    EXPECT_NEAR(result.values[i].value, kPendulumTruth[i], tolerance * kPendulumTruth[i]) << result.values[i].address;
}

TEST(Fit, RecoversMassAndFrictionOfAPendulumByMultipleShooting) {
  const FitResult result = fit_pendulum({pendulum_trial(8.0, kNoise, 3)});
  expect_truth(result, 0.02);
  for (std::size_t i = 0; i < kPendulumTruth.size(); ++i) {
    EXPECT_LT(result.values[i].lower_95, kPendulumTruth[i]) << result.values[i].address;
    EXPECT_GT(result.values[i].upper_95, kPendulumTruth[i]) << result.values[i].address;
  }
  ASSERT_EQ(result.stages.size(), 3u);
  EXPECT_EQ(result.stages[0].segments, 80);
  EXPECT_EQ(result.stages[2].name, "free run");
  EXPECT_NEAR(result.stages[2].residual, 1.0, 0.05);  // 1600 samples of known noise: ±2 %
  EXPECT_THAT(result.cannot_tell, IsEmpty());
}

TEST(Fit, RecoversThemByFreeRunFromAGivenStart) {
  Trial trial = pendulum_trial(4.0, kNoise, 3);
  trial.initial = {{InitialKnowledge::given, 0.3, 0.0}};
  FitSection options;
  options.method = "free_run";
  const FitResult result = fit_pendulum({trial}, options);
  expect_truth(result, 0.05);
  EXPECT_EQ(result.samples, 801u);  // a given start leaves every sample to be scored
}

TEST(Fit, ScoresNothingOfTheFirst50MillisecondsWhenTheStartComesFromData) {
  FitSection options;
  options.method = "free_run";
  const FitResult result = fit_pendulum({pendulum_trial(4.0, kNoise, 3)}, options);
  EXPECT_EQ(result.samples, 801u - 11u);
}

void expect_same_digits(const FitResult& a, const FitResult& b) {
  EXPECT_EQ(a.parameters(), b.parameters());
  EXPECT_EQ(a.simulations, b.simulations);
  for (std::size_t i = 0; i < a.values.size(); ++i) EXPECT_EQ(a.values[i].standard_error, b.values[i].standard_error);
}

TEST(Fit, GivesTheSameDigitsForAnyNumberOfThreads) {
  const std::vector<Trial> trials = {pendulum_trial(3.0, kNoise, 3), pendulum_trial(2.0, kNoise, 4)};
  expect_same_digits(fit_pendulum(trials, {}, 1), fit_pendulum(trials, {}, 2));
}

TEST(Fit, GivesTheSameDigitsWhereStartsRunSideBySide) {
  FitSection options;
  options.method = "free_run";  // one trial: five simulations at a time, so that sixteen threads serve four starts
  const std::vector<Trial> trials = {pendulum_trial(3.0, kNoise, 3)};
  expect_same_digits(fit_pendulum(trials, options, 1), fit_pendulum(trials, options, 16));
}

TEST(Fit, LeavesOutSegmentsThatHoldTooFewSamples) {
  const std::vector<Trial> trials = {record(OneJointModel(pendulum), kPendulumTruth, regular_times(81, 10.0),
                                            two_sines(8.0, 1.5), {{0.3}, {0.0}}, kNoise, 3)};
  const FitResult result = fit_pendulum(trials);
  expect_truth(result, 0.05);
  EXPECT_THAT(result.notes, Contains("segments of 0.1 s hold too few samples and are left out"));
}

TEST(Fit, HuberIsNotPulledByWildReadings) {
  Trial trial = pendulum_trial(6.0, kNoise, 3);
  for (Eigen::Index row = 50; row < trial.measured.samples.rows(); row += 29) trial.measured.samples(row, 0) += 0.5;
  expect_truth(fit_pendulum({trial}), 0.03);
  FitSection squared;
  squared.loss = "squared";
  EXPECT_GT(std::abs(fit_pendulum({trial}, squared).values[2].value - kPendulumTruth[2]), 0.03 * kPendulumTruth[2]);
}

TEST(Fit, MaskedSamplesAndHeldOutTrialsDoNotCount) {
  Trial masked = pendulum_trial(4.0, kNoise, 3);
  masked.measured.samples.middleRows(200, 300).setConstant(std::numeric_limits<double>::quiet_NaN());
  Trial nonsense = pendulum_trial(4.0, kNoise, 4);
  nonsense.measured.samples.setConstant(7.0);
  nonsense.held_out = true;
  const FitResult result = fit_pendulum({masked, nonsense});
  expect_truth(result, 0.05);
  EXPECT_EQ(result.samples, 801u - 300u - 11u);
}

TEST(Fit, SegmentsLongerThanTheTrialAreLeftToTheFreeRun) {
  FitSection options;
  options.segments = {0.1, 100.0};
  const FitResult result = fit_pendulum({pendulum_trial(4.0, kNoise, 3)}, options);
  ASSERT_EQ(result.stages.size(), 2u);
  EXPECT_EQ(result.stages[1].segments, 1);
  expect_truth(result, 0.05);
}

TEST(Fit, HorizonInSecondsAndAutomaticHorizonCutTheLastStage) {
  FitSection options;
  options.horizon = "1.0";
  EXPECT_EQ(fit_pendulum({pendulum_trial(4.0, kNoise, 3)}, options).stages.back().segments, 4);
  options.horizon = "auto";
  // A line through half a second tells a velocity to σ√12/(T√N) = 0.7 mrad/s: 0.2 mrad of a swing of 0.7 Hz, for ever.
  EXPECT_EQ(fit_pendulum({pendulum_trial(4.0, kNoise, 3)}, options).stages.back().name, "free run");
  // Through 50 ms it is 21 mrad/s, which makes twice the noise after 0.12 s, a little later under a spring.
  options.segments = {0.05};
  const FitStage last = fit_pendulum({pendulum_trial(4.0, kNoise, 3)}, options).stages.back();
  EXPECT_NEAR(last.segment, 0.13, 0.03);
  EXPECT_THAT(last.name, HasSubstr("automatic horizon"));
}

TEST(Fit, OneSampleIsNothingToFitTo) {
  try {
    fit_pendulum({pendulum_trial(0.0, kNoise, 3)});
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("nothing to fit to"));
  }
}

TEST(Fit, OnlyHeldOutTrialsAreNothingToFitTo) {
  Trial trial = pendulum_trial(1.0, kNoise, 3);
  trial.held_out = true;
  EXPECT_THROW(fit_pendulum({trial}), Error);
}

TEST(Fit, AModelWithoutFreeValuesIsNotFitted) {
  const OneJointModel model(pendulum);
  const ModelDefinition definition = define({}, one_joint_robot());
  const std::vector<Trial> trials = {pendulum_trial(1.0, kNoise, 3)};
  EXPECT_THAT(fit({definition, model, trials, {}}).values, IsEmpty());
}

TEST(Fit, InvalidSimulationsInsideTheSearchDoNotEndIt) {
  // No simulation below 0.75 kg: close under the answer, and all of the bounds' lower part.
  const OneJointModel model([](std::span<const double> values, double q, double v, double u) {
    return values[0] < 0.75 ? std::nan("") : pendulum(values, q, v, u);
  });
  ModelDefinition definition = pendulum_definition();
  definition.free[0].start = 6.0;
  const std::vector<Trial> trials = {pendulum_trial(4.0, kNoise, 3)};
  const FitResult result = fit({definition, model, trials, {}, 1, {2}});
  expect_truth(result, 0.05);
  EXPECT_GT(result.invalid_simulations, 0u);
}

TEST(Fit, SaysWhenNoStartCanBeSimulated) {
  const OneJointModel model([](std::span<const double>, double, double, double) { return std::nan(""); });
  const ModelDefinition definition = pendulum_definition();
  const std::vector<Trial> trials = {pendulum_trial(1.0, kNoise, 3)};
  try {
    fit({definition, model, trials, {}});
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("the joint's position is not finite"));
  }
}

TEST(Fit, AnEffectThatIsNotThereEndsAtItsBound) {
  const OneJointModel model(pendulum);
  const std::vector<double> frictionless = {0.8, 0.05, 0.0};
  const ModelDefinition definition = pendulum_definition();
  bool at_zero = false;
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    const std::vector<Trial> trials = {
        record(model, frictionless, regular_times(401, 200.0), two_sines(2.0, 1.5), {{0.3}, {0.0}}, kNoise, seed)};
    const FittedValue friction = fit({definition, model, trials, {}}).values[2];
    EXPECT_LT(friction.value, 0.01);
    at_zero = at_zero || friction.at_lower_bound;
    EXPECT_EQ(friction.at_lower_bound, std::isnan(friction.standard_error));
  }
  EXPECT_TRUE(at_zero);  // noise pushes half of them there
}

TEST(Fit, FindsADeadZoneThatHasNoGradientAtZero) {
  // q'' = dead_zone(u, w) − 2 v; the width starts at 0 and commands come in two sizes.
  const OneJointModel model([](std::span<const double> values, double, double v, double u) {
    return std::copysign(std::max(std::abs(u) - values[0], 0.0), u) - 2.0 * v;
  });
  const ModelDefinition definition = define({free_value("effect.gap.width", 0.0, 0.0, 100.0)}, one_joint_robot());
  const std::vector<Trial> trials = {
      record(model, {0.4}, regular_times(801, 200.0), two_sines(4.0, 1.0), {{0.0}, {0.0}}, kNoise, 3)};
  const FitResult result = fit({definition, model, trials, {}});
  EXPECT_NEAR(result.values[0].value, 0.4, 0.01);
  EXPECT_GE(result.agreeing, 2);
}

/// A decay that starts far off drags the frequency, which has a minimum at each period, away from what is known of it.
TEST(Fit, GoesBackToWhatTheExperimentSaysOfAnEffect) {
  const FormulaModel model([](std::span<const double> values, double t) {
    return 5.0 * std::exp(-values[0] * t) + 0.2 * std::sin(values[1] * t);
  });
  const std::vector<Trial> trials = {record(model, {0.3, 6.28}, regular_times(1001, 200.0), {}, {}, kNoise, 3)};
  FitSection options;
  options.starts = 1;
  const auto found = [&](const std::string& address) {
    const ModelDefinition definition =
        define({free_value("body.arm.mass", 5.0, 0.01, 50.0), free_value(address, 6.1, 0.1, 100.0)});
    return fit({definition, model, trials, options}).values[1].value;
  };
  EXPECT_GT(std::abs(found("joint.hinge.stiffness") - 6.28), 0.5) << "of the robot's own values nothing is said";
  EXPECT_NEAR(found("effect.ripple.frequency"), 6.28, 0.01);
}

/// A phase that starts half a period off leads the frequency elsewhere, and ends as no phase for what is known of it.
TEST(Fit, GoesBackToAnEffectBesideABaseThatFitsIt) {
  const FormulaModel model(
      [](std::span<const double> values, double t) { return std::sin(values[1] * t + values[0]); });
  const std::vector<Trial> trials = {record(model, {1.0, 2.0}, regular_times(1001, 200.0), {}, {}, kNoise, 3)};
  FitSection options;
  options.starts = 1;
  const ModelDefinition definition = define(
      {free_value("joint.hinge.offset", 4.0, -10.0, 10.0), free_value("effect.ripple.frequency", 2.2, 0.1, 100.0)});
  const FitResult result = fit({definition, model, trials, options});
  EXPECT_NEAR(result.values[0].value, 1.0, 0.01);
  EXPECT_NEAR(result.values[1].value, 2.0, 0.01);
}

/// An oscillator whose readings carry a ripple that it does not have. Short segments see little but the ripple; over a
/// whole trial the frequency has a minimum at each period.
class RippledOscillator : public testing::Test {
 protected:
  static constexpr double kStiffness = 36.0;

  void record_with(double ripple) {
    trials_ = {record(model_, {kStiffness}, regular_times(4001, 200.0), {}, {{1.0}, {0.0}}, kNoise, 3)};
    for (Eigen::Index row = 0; row < trials_[0].measured.times.size(); ++row)
      trials_[0].measured.samples(row, 0) += ripple * std::sin(15.0 * trials_[0].measured.times(row));
    trials_[0].initial = {{InitialKnowledge::given, 1.0, 0.0}};
  }
  FitResult fit_from(double start) const {
    const ModelDefinition definition =
        define({free_value("joint.hinge.stiffness", start, 1.0, 1e4)}, one_joint_robot());
    FitSection options;
    options.starts = 1;
    options.loss = "squared";  // then the fit minimises the error that is asked for here
    return fit({definition, model_, trials_, options});
  }
  /// Of a free run from the given start.
  double error_at(double stiffness) const {
    const Trial right = record(model_, {stiffness}, trials_[0].measured.times, {}, {{1.0}, {0.0}}, 0.0, 1);
    return std::sqrt((right.measured.samples - trials_[0].measured.samples).squaredNorm() /
                     static_cast<double>(right.measured.times.size()));
  }

  const OneJointModel model_{[](std::span<const double> values, double q, double, double) { return -values[0] * q; }};
  std::vector<Trial> trials_;
};

TEST_F(RippledOscillator, IsNeverLeftWithALargerErrorThanItsFitBeganWith) {
  bool went_back = false;
  for (const double ripple : {0.04, 0.08, 0.12, 0.2}) {
    record_with(ripple);
    const FitResult result = fit_from(kStiffness);
    EXPECT_LE(error_at(result.values[0].value), 1.001 * error_at(kStiffness)) << "ripple " << ripple;
    EXPECT_NEAR(result.values[0].value, kStiffness, 0.1) << "ripple " << ripple;
    for (const std::string& note : result.notes)
      went_back = went_back || note.starts_with("the fit may be at a local minimum");
  }
  EXPECT_TRUE(went_back) << "no ripple led astray; the test shows nothing";
}

TEST_F(RippledOscillator, IsFittedWithoutANoteWhereTheStagesAgree) {
  record_with(0.0);
  const FitResult result = fit_from(35.9);
  EXPECT_NEAR(result.values[0].value, kStiffness, 0.1);
  for (const std::string& note : result.notes) EXPECT_THAT(note, testing::Not(HasSubstr("disagree")));
}

TEST(Fit, ReportsProgressThatEnds) {
  const OneJointModel model(pendulum);
  const ModelDefinition definition = pendulum_definition();
  const std::vector<Trial> trials = {pendulum_trial(2.0, kNoise, 3)};
  std::vector<double> fractions;
  const auto note = [&](const Progress& progress) { fractions.push_back(progress.fraction); };
  fit({definition, model, trials, {}, 1, {.threads = 1, .progress = note}});
  ASSERT_FALSE(fractions.empty());
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_GT(fractions.back(), 0.5);
  EXPECT_LE(fractions.back(), 1.0);
}

std::atomic<std::int64_t> looks_at_the_clock = 0;
std::int64_t counting_clock() { return ++looks_at_the_clock; }

/// A fit that is stopped after so many looks at the clock, one before each simulation: no machine's speed counts.
class StoppedFit : public testing::Test {
 protected:
  FitResult stopped_after(std::int64_t looks, bool best_at_time_limit = true) {
    const OneJointModel model(pendulum);
    TimeLimit limit(1e-3 * static_cast<double>(looks), "1 s", counting_clock);
    const std::int64_t begin = looks_at_the_clock;
    FitResult result = fit({.definition = definition_,
                            .model = model,
                            .trials = trials_,
                            .options = {},
                            .work = {.stop = Stop(limit)},
                            .best_at_time_limit = best_at_time_limit});
    used_ = looks_at_the_clock - begin;
    return result;
  }

  const ModelDefinition definition_ = pendulum_definition();
  const std::vector<Trial> trials_ = {pendulum_trial(4.0, kNoise, 3)};
  std::int64_t used_ = 0;
};

TEST_F(StoppedFit, KeepsTheBestValuesAndSaysThatItDidNotConverge) {
  const FitResult whole = stopped_after(1'000'000'000);
  ASSERT_FALSE(whole.stopped);
  const std::int64_t all = used_;
  const FitResult half = stopped_after(all / 2);
  EXPECT_TRUE(half.stopped);
  EXPECT_NEAR(half.values[0].value, kPendulumTruth[0], 0.05);
  EXPECT_TRUE(std::isnan(half.values[0].lower_95));
  ASSERT_FALSE(half.stages.empty());
  EXPECT_FALSE(half.stages.back().converged);
  EXPECT_THAT(half.notes, Contains(HasSubstr("the fit did not converge: stopped by --time-limit 1 s")));

  const FitResult start = stopped_after(all / 100);
  EXPECT_TRUE(start.stopped);
  EXPECT_LT(half.stages.back().residual, 0.5 * start.stages.back().residual);
}

TEST_F(StoppedFit, ThrowsWhereNobodyWantsTheBestSoFar) { EXPECT_THROW(stopped_after(500, false), TimeIsUp); }

TEST_F(StoppedFit, HasTheSameDigitsWithALimitThatIsNotReached) {
  const FitResult limited = stopped_after(1'000'000'000);
  const OneJointModel model(pendulum);
  const FitResult free = fit({definition_, model, trials_, {}, 1, {1}});
  EXPECT_EQ(limited.parameters(), free.parameters());
}

}  // namespace
}  // namespace lacuna
