#include "baselines/baselines.h"
#include "baselines/random_guess.h"

#include "bench/bench_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hidden_effects {
namespace {

constexpr double kNoise = 2e-4;           ///< rad
constexpr std::size_t kSamples = 601;     ///< 3 s
constexpr double kFrictionTorque = 0.06;  ///< N·m, a sixth of the commands' RMS

/// Recordings of a pendulum that is 8 % lighter than its user wrote, with encoder noise.
Observed pendulum(const std::vector<PlacedLaw>& hidden, const std::vector<double>& parameters) {
  const Rig rig = servo_pendulum();
  Observed seen{{rig.nominal, rig.free, {}}, {}, {}};
  PlantModel truth = seen.base;
  truth.laws = hidden;
  Eigen::VectorXd values = seen.nominal();
  values[0] *= 0.92;
  values = with_parameters(values, parameters);
  for (int t = 0; t < 2; ++t) {
    FittedTrial trial;
    trial.excitation.interval = rig.interval;
    trial.excitation.commands = commands(rig, 2 * t, 5.0, 5);
    trial.excitation.commands.front().resize(kSamples);
    trial.readings = predict(truth, values, trial.excitation, {Coordinates::Zero(1), Coordinates::Zero(1)});
    bench::Normal normal(static_cast<std::uint64_t>(17 + t));
    for (double& reading : trial.readings.front()) reading += kNoise * normal();
    seen.trials.push_back(std::move(trial));
  }
  return seen;
}

/// So that a test needs few fits.
void leave_only(Observed& seen, const std::vector<std::string>& effects) {
  for (const LawKind& kind : all_laws())
    if (std::find(effects.begin(), effects.end(), kind.effect) == effects.end()) seen.withheld.push_back(kind.effect);
}

const std::vector<std::string> kFew = {"coulomb_friction", "cubic_stiffness", "torque_gain", "command_delay",
                                       "sensor_offset"};

const BaselineAnswer& named(const std::vector<BaselineAnswer>& answers, const std::string& name) {
  return *std::find_if(answers.begin(), answers.end(), [&](const BaselineAnswer& one) { return one.name == name; });
}

TEST(Baselines, ThreeOfThemFindLargeDryFrictionInEasyData) {
  Observed seen = pendulum({{&law_kind("coulomb_friction"), 0}}, {kFrictionTorque});
  leave_only(seen, kFew);
  const std::vector<BaselineAnswer> answers = run_baselines(seen, 1);
  for (const char* name : {"cross_validated_refit", "effective_bic", "stepwise_regression"}) {
    const BaselineAnswer& answer = named(answers, name);
    EXPECT_EQ(answer.ranking.front().effect, "coulomb_friction") << name;
    EXPECT_FALSE(answer.nothing_missing()) << name;
    EXPECT_GT(answer.seconds, 0.0) << name;
  }
}

TEST(Baselines, TheTwoThatRefitSayThatNothingIsMissingWhereNothingIsHidden) {
  Observed seen = pendulum({}, {});
  leave_only(seen, kFew);
  const std::vector<BaselineAnswer> answers = run_baselines(seen, 1);
  EXPECT_TRUE(named(answers, "cross_validated_refit").nothing_missing());
  EXPECT_TRUE(named(answers, "effective_bic").nothing_missing());
}

TEST(Baselines, WhatIsWithheldIsNoCandidate) {
  Observed seen = pendulum({}, {});
  const RecordedMotions motions = recorded_motions(seen);
  const std::size_t all = all_candidates(seen, motions).size();
  seen.withheld = {"coulomb_friction"};
  const std::vector<Candidate> left = all_candidates(seen, motions);
  EXPECT_EQ(left.size(), all - 1);
  for (const Candidate& candidate : left) EXPECT_NE(candidate.law.kind->effect, "coulomb_friction");
}

TEST(Baselines, GuessesFollowFromTheirSeed) {
  const Observed seen = pendulum({}, {});
  const std::vector<Candidate> candidates = all_candidates(seen, recorded_motions(seen));
  const auto order = [&](std::uint64_t seed) {
    std::vector<std::string> effects;
    for (const RankedEffect& one : by_random_guess(candidates, seed).ranking) effects.push_back(one.effect);
    return effects;
  };
  EXPECT_EQ(order(3), order(3));
  EXPECT_NE(order(3), order(4));
}

TEST(Baselines, OnlyTheRecordedSideOfTrialsToFitIsSeen) {
  MadeCase made;
  const Rig rig = servo_pendulum();
  made.base = {rig.nominal, rig.free, {}};
  made.base_values = Eigen::Vector2d(9.0, 9.0);
  for (const bool held_out : {false, false, true}) {
    MadeTrial trial;
    trial.held_out = held_out;
    trial.applied.commands = {{1.0, 2.0}};
    trial.applied.forces = {{5.0, 5.0}};
    trial.recorded_commands = {{1.5, 2.5}};
    trial.readings = {{0.1, 0.2}};
    trial.clean = {{7.0, 7.0}};
    made.trials.push_back(trial);
  }
  const Observed seen = observed(made);
  ASSERT_EQ(seen.trials.size(), 2u);
  EXPECT_EQ(seen.trials[0].excitation.commands, made.trials[0].recorded_commands);
  EXPECT_TRUE(seen.trials[0].excitation.forces.empty());
  EXPECT_EQ(seen.trials[0].readings, made.trials[0].readings);
  EXPECT_DOUBLE_EQ(seen.nominal()[0], 0.5);  // kg, as the rig is written down
  made.trials.erase(made.trials.begin());
  EXPECT_THROW(observed(made), std::invalid_argument);
}

}  // namespace
}  // namespace hidden_effects
