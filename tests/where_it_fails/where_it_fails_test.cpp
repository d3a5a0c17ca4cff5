#include "where_it_fails/where_it_fails.h"

#include "where_it_fails/motion.h"
#include "where_it_fails/wheel_rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace lacuna {
namespace {

WhereItFails asked(const Rig& rig, int threads = 1) {
  return where_it_fails({rig.definition, *rig.model, rig.trials, {}, rig.comparison, {threads}});
}

const Finding* dependence(const WhereItFails& where, ViewKind view) {
  for (const Finding& finding : where.findings)
    if (finding.kind == FindingKind::dependence && finding.view == view) return &finding;
  return nullptr;
}

bool names(const WhereItFails& where, const std::vector<std::size_t>& features, FeatureKind kind) {
  return std::any_of(features.begin(), features.end(),
                     [&](std::size_t feature) { return where.table.features[feature].kind == kind; });
}

TEST(WhereItFails, FrictionDependsOnTheDirectionOfMotion) {
  const WhereItFails where = asked(rig_lacking([](double, double v, double) { return -0.2 * std::tanh(v / 0.01); }));
  const Finding* finding = dependence(where, ViewKind::acceleration);
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(where.table.features[finding->features.front()].kind, FeatureKind::direction);
  EXPECT_GT(finding->share, 0.4);  // the turn is smeared over 100 ms
  EXPECT_LT(finding->p, 0.001);
  EXPECT_TRUE(names(where, finding->not_on, FeatureKind::time));
  EXPECT_TRUE(names(where, finding->not_on, FeatureKind::command));
}

TEST(WhereItFails, AForceNearReversalsIsARegime) {
  constexpr double kSlow = 0.25;  // rad/s
  const WhereItFails where = asked(
      rig_lacking([](double, double v, double) { return std::abs(v) < kSlow ? -1.5 * std::copysign(1.0, v) : 0.0; }));
  const auto regime = std::find_if(where.findings.begin(), where.findings.end(), [](const Finding& finding) {
    return finding.kind == FindingKind::regime && finding.view == ViewKind::acceleration;
  });
  ASSERT_NE(regime, where.findings.end());
  EXPECT_GT(regime->share, 0.8);
  EXPECT_LT(regime->share_of_samples, 0.25);
  ASSERT_EQ(regime->conditions.size(), 1u);
  const Condition& only = regime->conditions.front();
  const FeatureKind kind = where.table.features[only.feature].kind;
  EXPECT_TRUE(kind == FeatureKind::since_reversal || kind == FeatureKind::speed);
  EXPECT_TRUE(std::isinf(only.lower));
  // At some 4 rad/s² the wheel is slower than kSlow for 0.13 s, which is seen through 0.1 s.
  EXPECT_LT(only.upper, 0.4);
}

TEST(WhereItFails, NoiseAloneIsNowhere) {
  constexpr int kDraws = 12;
  int findings = 0;
  for (std::uint64_t seed = 0; seed < kDraws; ++seed)
    findings += asked(rig_lacking([](double, double, double) { return 0.0; }, seed)).findings.empty() ? 0 : 1;
  EXPECT_LE(findings, 1);  // promised: one in a hundred
}

TEST(WhereItFails, AConstantForceIsNoDependenceOnState) {
  const WhereItFails where = asked(rig_lacking([](double, double, double) { return 0.05; }));
  EXPECT_EQ(dependence(where, ViewKind::acceleration), nullptr);
  const ResidualView& view = where.views.back();
  ASSERT_EQ(view.kind, ViewKind::acceleration);
  EXPECT_NEAR(view.residuals.col(0).array().isFinite().select(view.residuals.col(0).array(), 0.0).sum() /
                  static_cast<double>(view.residuals.col(0).array().isFinite().count()),
              0.05, 0.005);
}

TEST(WhereItFails, TheNumberOfThreadsMakesNoDifference) {
  const Rig rig = rig_lacking([](double, double v, double) { return -0.3 * v; });
  const WhereItFails one = asked(rig, 1), two = asked(rig, 2);
  ASSERT_EQ(one.findings.size(), two.findings.size());
  for (std::size_t i = 0; i < one.findings.size(); ++i) {
    EXPECT_EQ(one.findings[i].share, two.findings[i].share);
    EXPECT_EQ(one.findings[i].p, two.findings[i].p);
  }
}

TEST(WhereItFails, HeldOutTrialsAreNotAsked) {
  Rig rig = rig_lacking([](double, double v, double) { return -0.3 * v; });
  rig.comparison.trials.front().held_out = true;
  const WhereItFails where = asked(rig);
  EXPECT_TRUE(where.views.empty());
  EXPECT_TRUE(where.findings.empty());
}

/// Findings about two trials of a sine, whose predictions swing wider by these parts.
std::vector<Finding> findings_of_swings(double first, double second) {
  const Eigen::VectorXd measured = Eigen::ArrayXd::LinSpaced(1000, 0.0, 20.0).sin();
  Comparison comparison;
  for (const double wider : {first, second}) {
    ChannelScore score;
    score.channel = "angle";
    score.samples = 1000;
    score.rmse = std::abs(wider) * std::sqrt(measured.squaredNorm() / 1000.0);
    score.normalised_rmse = score.rmse / std::sqrt((measured.array() - measured.mean()).square().mean());
    score.times_floor = score.rmse / kNoise;
    score.parts = error_parts(measured, (1.0 + wider) * measured);
    TrialComparison trial;
    trial.channels = {score};
    comparison.trials.push_back(trial);
  }
  ResidualView view;
  view.times_floor = 20.0;
  view.channels.resize(1);
  view.channels[0].channel = "angle";
  view.channels[0].share_of_error = 1.0;
  return findings_of(comparison, {view});
}

TEST(WhereItFails, SwingsAreTooWideOnlyWhereTheTrialsAgree) {
  EXPECT_TRUE(findings_of_swings(0.03, -0.03).empty());
  const std::vector<Finding> found = findings_of_swings(0.03, 0.03);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, FindingKind::magnitude);
  EXPECT_NEAR(found[0].size, 0.03, 1e-12);
  EXPECT_GT(found[0].share, 0.95);  // the rest is the sine's mean, which is not quite zero
}

TEST(Motion, CountsFromTheMomentItStops) {
  const Eigen::VectorXd times = Eigen::VectorXd::LinSpaced(7, 0.0, 6.0);
  Eigen::VectorXd velocities(7);
  velocities << 1.0, 1.0, 0.05, 0.0, -1.0, -1.0, 1.0;
  const Motion motion = motion_of(times, velocities, 0.1);
  const std::vector<double> direction = {1, 1, 0, 0, -1, -1, 1}, since = {0, 1, 0, 1, 2, 3, 0};
  for (std::size_t i = 0; i < direction.size(); ++i) {
    EXPECT_EQ(motion.direction(static_cast<Eigen::Index>(i)), direction[i]) << i;
    EXPECT_EQ(motion.since_reversal(static_cast<Eigen::Index>(i)), since[i]) << i;
  }
}

}  // namespace
}  // namespace lacuna
