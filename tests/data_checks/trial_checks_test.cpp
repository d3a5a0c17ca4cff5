#include "data_checks/trial_checks.h"

#include "fitting/numerics/seeded_noise.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr double kRows = 100.0;

void add_file(AccelerationTable& table) {
  Trial trial;
  trial.name = "run" + std::to_string(table.trials.size() + 1) + ".csv";
  table.trials.push_back(trial);
}

/// Lags of −0.2 to 0.2 s in steps of 0.01 s, and trials whose accelerations follow their commands best at some lag.
struct LaggedTrials {
  AccelerationTable table;
  CommandLags lags;

  explicit LaggedTrials(const std::vector<double>& best) {
    lags.lags = Eigen::VectorXd::LinSpaced(41, -0.2, 0.2);
    lags.interval = 0.01;
    for (const double lag : best) {
      CommandLagProfile profile;
      profile.trial = table.trials.size();
      profile.rows = profile.freedom = kRows;
      profile.power = 1e6;
      profile.squares = kRows + (1e5 * (lags.lags.array() - lag)).square() / 1e5;
      profile.early = profile.late = 0.5 * profile.squares;
      lags.profiles.push_back(profile);
      add_file(table);
    }
  }
  std::vector<DataWarning> checked() const { return trial_checks(table, lags); }
};

std::vector<std::string> said(const std::vector<DataWarning>& doubts) {
  std::vector<std::string> all;
  for (const DataWarning& doubt : doubts) all.push_back(doubt.sentence);
  return all;
}

TEST(TrialChecks, NameTheTrialWhoseLagIsAnother) {
  EXPECT_THAT(said(LaggedTrials({0.0, 0.0, 0.05}).checked()),
              ElementsAre(AllOf(StartsWith("run3.csv: "), HasSubstr("50 ms later"))));
  EXPECT_THAT(said(LaggedTrials({0.0, -0.05, 0.0}).checked()),
              ElementsAre(AllOf(StartsWith("run2.csv: "), HasSubstr("50 ms earlier"))));
}

TEST(TrialChecks, NameBothOfTwoTrialsOfWhichEitherMayBeShifted) {
  EXPECT_THAT(said(LaggedTrials({0.02, -0.04}).checked()), ElementsAre(HasSubstr("run1.csv and run2.csv")));
}

/// A delay that all trials share is an effect.
TEST(TrialChecks, DoNotDoubtALagThatAllTrialsShare) {
  EXPECT_THAT(LaggedTrials({0.05, 0.05, 0.05}).checked(), IsEmpty());
}

/// How commands are held between samples shifts them by up to an interval and a half.
TEST(TrialChecks, DoNotDoubtAShiftByOneInterval) { EXPECT_THAT(LaggedTrials({0.0, 0.0, 0.01}).checked(), IsEmpty()); }

TEST(TrialChecks, DoNotDoubtAClockThatGains) {
  LaggedTrials trials({0.0, 0.0, 0.05});
  CommandLagProfile& gains = trials.lags.profiles[2];
  gains.early = kRows + (1e5 * trials.lags.lags.array()).square() / 1e5;
  gains.late = kRows + (1e5 * (trials.lags.lags.array() - 0.1)).square() / 1e5;
  EXPECT_THAT(trials.checked(), IsEmpty());
}

/// With much of the motion unexplained at any lag, a lag means nothing.
TEST(TrialChecks, DoNotDoubtLagsWhereTheResidualIsLarge) {
  LaggedTrials trials({0.0, 0.0, 0.05});
  for (CommandLagProfile& profile : trials.lags.profiles) profile.power = 500.0;
  for (CommandLagProfile& profile : trials.lags.profiles) profile.squares.array() += 400.0;
  EXPECT_THAT(trials.checked(), IsEmpty());
}

/// Trials of one channel that accelerates `response` times as much as commanded, with white noise of deviation 1.
AccelerationTable responding(const std::vector<double>& responses) {
  AccelerationTable table;
  SeededNoise random(5, 0);
  for (const double response : responses) {
    ChannelAccelerations one;
    one.trial = table.trials.size();
    one.channel = "angle";
    one.unit = "rad/s^2";
    one.deviation = 1.0;
    one.uncommanded = Eigen::VectorXd::Zero(60);
    one.measured = one.position = one.velocity = Eigen::VectorXd(60);
    one.commanded.resize(60, 1);
    for (Eigen::Index i = 0; i < 60; ++i) {
      one.position(i) = random.normal();
      one.velocity(i) = random.normal();
      one.commanded(i, 0) = 30.0 * random.normal();
      one.measured(i) = response * one.commanded(i, 0) + random.normal();
    }
    table.channels.push_back(one);
    add_file(table);
  }
  return table;
}

TEST(TrialChecks, NameTheTrialOfAnotherRig) {
  const std::vector<DataWarning> doubts = trial_checks(responding({1.0, 1.0, 1.6}), {});
  EXPECT_THAT(said(doubts), ElementsAre(StartsWith("run3.csv contradicts the other files")));
  EXPECT_TRUE(doubts[0].voids);
}

TEST(TrialChecks, DoNotDoubtTrialsThatShareAResponseOtherThanTheModels) {
  EXPECT_THAT(trial_checks(responding({1.6, 1.6, 1.6}), {}), IsEmpty());
}

}  // namespace
}  // namespace lacuna
