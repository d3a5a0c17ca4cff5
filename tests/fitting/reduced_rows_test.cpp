#include "fitting/shooting/reduced_rows.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace lacuna::reduced_rows_test {
namespace {

constexpr double kRounding = 1e-12;

/// Segments of three readings and a prior.
class ThreeReadings : public SegmentedProblem {
 public:
  const Eigen::VectorXd& lower() const override { return none_; }
  const Eigen::VectorXd& upper() const override { return none_; }
  Eigen::Index robust_rows(std::size_t) const override { return 3; }
  bool residuals(const FitPoint&, std::vector<Eigen::VectorXd>&) override { return false; }
  void linearize(const FitPoint&, const std::vector<Eigen::VectorXd>&, std::vector<SegmentJacobian>&) override {}

 private:
  const Eigen::VectorXd none_;
};

SegmentJacobian derivatives() {
  SegmentJacobian jacobian;
  jacobian.values.resize(4, 2);
  jacobian.values << 1.0, 2.0, 3.0, -1.0, 0.5, 4.0, 0.0, 0.0;
  jacobian.state = Eigen::Vector4d(2.0, 1.0, -1.0, 0.5);
  return jacobian;
}

const Eigen::VectorXd kResiduals = Eigen::Vector4d(0.5, -6.0, 1.0, 9.0);

/// What the initial state explains as well is no information about the values: the Schur complement of the state in the
/// normal equations.
TEST(ReducedRows, HaveTheInformationThatIsLeftOnceTheStateIsFitted) {
  const SegmentJacobian one = derivatives();
  const std::vector<ReducedRows> rows = reduce(ThreeReadings(), {kResiduals}, {one}, {});
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_LT((rows[0].sensitivity.transpose() * one.state).norm(), kRounding);
  Eigen::MatrixXd both(4, 3);
  both << one.values, one.state;
  const Eigen::MatrixXd covariance = (both.transpose() * both).inverse();
  EXPECT_LT((information(rows).inverse() - covariance.topLeftCorner(2, 2)).norm(), kRounding);
}

TEST(ReducedRows, SumTheInformationOfTheirSegments) {
  const Eigen::MatrixXd one = information(reduce(ThreeReadings(), {kResiduals}, {derivatives()}, {}));
  const std::vector<SegmentJacobian> twice = {derivatives(), derivatives()};
  EXPECT_LT((information(reduce(ThreeReadings(), {kResiduals, kResiduals}, twice, {})) - 2.0 * one).norm(), kRounding);
}

/// A reading beyond the threshold tells nothing more and pulls with the threshold alone; a prior counts squared.
TEST(ReducedRows, FollowTheLossInReadingsButNotInPriors) {
  const std::vector<ReducedRows> rows = reduce(ThreeReadings(), {kResiduals}, {derivatives()}, RobustLoss{3.0});
  EXPECT_EQ(rows[0].curvature, Eigen::Vector4d(1.0, 0.0, 1.0, 1.0));
  EXPECT_EQ(rows[0].score, Eigen::Vector4d(0.5, -3.0, 1.0, 9.0));
  const Eigen::VectorXd weighted = rows[0].curvature.asDiagonal() * derivatives().state;
  EXPECT_LT((rows[0].sensitivity.transpose() * weighted).norm(), kRounding);
}

TEST(ReducedRows, WithoutAStateAreTheDerivatives) {
  SegmentJacobian one = derivatives();
  one.state.resize(4, 0);
  EXPECT_EQ(reduce(ThreeReadings(), {kResiduals}, {one}, {})[0].sensitivity, one.values);
}

}  // namespace
}  // namespace lacuna::reduced_rows_test
