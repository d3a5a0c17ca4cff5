#include "diagnosis/nuisance.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

constexpr Eigen::Index kBins = 40;

/// A segment whose start explains a constant and a slope.
LinearSegment segment_of(const Eigen::VectorXd& times) {
  LinearSegment segment;
  segment.residual = Eigen::VectorXd::Zero(kBins);
  segment.state.resize(kBins, 2);
  segment.state << Eigen::VectorXd::Ones(kBins), times;
  return segment;
}

TEST(IsAmong, CountsWhatAStartMakesUpForAsNoDifference) {
  const Eigen::VectorXd times = Eigen::VectorXd::LinSpaced(kBins, 0.0, 1.0);
  const Eigen::VectorXd bend = (6.0 * times).array().sin();
  const Eigen::VectorXd shifted = 2.0 * bend + 5.0 * times + Eigen::VectorXd::Constant(kBins, 3.0);
  const std::vector<LinearSegment> free_start = {segment_of(times)};
  EXPECT_TRUE(is_among({shifted}, {bend}, free_start));
  LinearSegment known = segment_of(times);
  known.state.resize(kBins, 0);
  EXPECT_FALSE(is_among({shifted}, {bend}, {known}));
}

TEST(IsAmong, ToleratesAThirtiethOfThePower) {
  const Eigen::VectorXd times = Eigen::VectorXd::LinSpaced(kBins, 0.0, 1.0);
  const Eigen::VectorXd one = (6.0 * times).array().sin(), other = (19.0 * times).array().cos();
  const std::vector<LinearSegment> segments = {segment_of(times)};
  EXPECT_TRUE(is_among({one + 0.1 * other}, {one}, segments));
  EXPECT_FALSE(is_among({one + 0.5 * other}, {one}, segments));
}

}  // namespace
}  // namespace lacuna
