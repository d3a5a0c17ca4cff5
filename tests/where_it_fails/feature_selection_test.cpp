#include "where_it_fails/feature_selection.h"

#include "fitting/numerics/seeded_noise.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

constexpr Eigen::Index kRowsOfTable = 2000;
enum Column : std::size_t { kPosition, kVelocity, kDirection, kClock };

/// A swing of many periods, and time.
FeatureTable swing_table() {
  FeatureTable table;
  table.features = {{FeatureKind::position, "position", "", "rad"},
                    {FeatureKind::velocity, "velocity", "", "rad/s"},
                    {FeatureKind::direction, "direction of motion", "", "1"},
                    {FeatureKind::time, "time", "", "s"}};
  table.values.resize(kRowsOfTable, 4);
  for (Eigen::Index i = 0; i < kRowsOfTable; ++i) {
    const double t = 0.01 * static_cast<double>(i), phase = 6.0 * t + 2.0 * std::sin(1.7 * t);
    table.trial.push_back(0);
    table.sample.push_back(i);
    table.values.row(i) << std::sin(phase), std::cos(phase), std::copysign(1.0, std::cos(phase)), t;
  }
  return table;
}

Eigen::VectorXd white(std::uint64_t stream) {
  SeededNoise random(9, stream);
  return Eigen::VectorXd::NullaryExpr(kRowsOfTable, [&] { return random.normal(); });
}

std::vector<std::size_t> selected_of(const ChannelTests& tests) {
  std::vector<std::size_t> all;
  for (const ChannelTests::Selected& one : tests.selected) all.push_back(one.feature);
  return all;
}

ChannelTests selection(const Eigen::VectorXd& residual, const Eigen::MatrixXd& covariates = {},
                       const std::vector<std::size_t>& unasked = {}) {
  const FeatureTable table = swing_table();
  ChannelTests tests;
  select_features({residual, covariates, table, 4, unasked}, tests);
  return tests;
}

TEST(FeatureSelection, NamesWhatTheResidualDependsOnAndNothingElse) {
  const ChannelTests tests = selection(2.0 * swing_table().values.col(kDirection) + white(1));
  EXPECT_THAT(selected_of(tests), ElementsAre(kDirection));
  EXPECT_NEAR(tests.selected[0].share, 4.0 / 5.0, 0.05);
  EXPECT_LT(tests.selected[0].p, 1e-4);
  EXPECT_THAT(tests.not_on, UnorderedElementsAre(kPosition, kVelocity, kClock));
}

TEST(FeatureSelection, TakesTheOneThatExplainsMostFirst) {
  const FeatureTable table = swing_table();
  const ChannelTests tests = selection(table.values.col(kDirection) + 4.0 * table.values.col(kPosition) + white(1));
  EXPECT_THAT(selected_of(tests), ElementsAre(kPosition, kDirection));
}

TEST(FeatureSelection, SelectsNothingOfNoise) {
  const ChannelTests tests = selection(white(2));
  EXPECT_THAT(tests.selected, IsEmpty());
  EXPECT_THAT(tests.not_on, ElementsAre(kPosition, kVelocity, kDirection, kClock));
}

/// A fiftieth of the squares, however sure.
TEST(FeatureSelection, SelectsNothingThatExplainsLessThanATwentieth) {
  const ChannelTests tests = selection(swing_table().values.col(kDirection) / 7.0 + white(1));
  EXPECT_TRUE(outside_band(tests.features[kDirection], 4));
  EXPECT_THAT(tests.selected, IsEmpty());
}

TEST(FeatureSelection, DoesNotTestWhatIsNotAsked) {
  const ChannelTests tests = selection(2.0 * swing_table().values.col(kDirection) + white(1), {}, {kDirection});
  EXPECT_FALSE(tests.features[kDirection].testable);
  EXPECT_THAT(selected_of(tests), Not(Contains(kDirection)));
}

TEST(FeatureSelection, LeavesToCovariatesWhatTheyExplain) {
  const Eigen::VectorXd other = white(3);
  const Eigen::VectorXd residual = 3.0 * other + 2.0 * swing_table().values.col(kDirection) + white(1);
  const ChannelTests tests = selection(residual, other);
  EXPECT_THAT(selected_of(tests), ElementsAre(kDirection));
}

/// Dry friction, part of which a fitted damping took over: what remains averages to almost zero at each velocity.
TEST(FeatureSelection, FindsBesideTheLinearTermsWhatFittedValuesHide) {
  const FeatureTable table = swing_table();
  const Eigen::VectorXd direction = table.values.col(kDirection), velocity = table.values.col(kVelocity);
  const double absorbed = direction.dot(velocity) / velocity.squaredNorm();
  const ChannelTests tests = selection(2.0 * (direction - absorbed * velocity) + 0.5 * white(1), white(4));
  EXPECT_THAT(selected_of(tests), Contains(kDirection));
}

TEST(FeatureSelection, SaysOfAConstantResidualThatItsMeanIsNotZero) {
  const ChannelTests tests = selection(Eigen::VectorXd::Constant(kRowsOfTable, 1.0) + 0.5 * white(1));
  EXPECT_LT(tests.mean.p, 1e-6);
  EXPECT_THAT(tests.selected, IsEmpty());
}

TEST(OutsideBand, CountsTheFamilyOfTests) {
  IndependenceTest test;
  test.p = 0.001;
  EXPECT_FALSE(outside_band(test, 1)) << "was not tested";
  test.testable = true;
  EXPECT_TRUE(outside_band(test, 9));
  EXPECT_FALSE(outside_band(test, 11));
}

}  // namespace
}  // namespace lacuna
