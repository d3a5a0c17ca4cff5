#include "prediction/descent.h"

#include "prediction/one_joint_rig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

constexpr double kDamping = 0.5;  // 1/s
constexpr int kMostSteps = 20;

FreeValue damping(double upper = 10.0) { return analytic::free_value("b", 0.1, 0.0, upper); }

/// A damped spring whose damping is fitted to predictions of it.
struct SpringDescent {
  explicit SpringDescent(const std::vector<FreeValue>& free = {damping()},
                         const OneJointRig::Model::Acceleration& acceleration = damped_spring)
      : rig(acceleration, free, std::vector<double>(free.size(), kDamping)), ladder(rig.ladder({0.5, 2.0})) {}

  struct Descended {
    PredictionFit fit;
    std::uint64_t simulations = 0;
  };
  Descended descend_from(const std::vector<double>& values, const LikeModel& like = {},
                         LastSteps last = LastSteps::anew) const {
    LadderPredictions predictions = rig.predictions(ladder);
    Descended made;
    made.fit = descend(predictions, predictions.at_smoothed_starts(rig.at(values)), kMostSteps, like,
                       like.empty() ? std::vector<std::string>{} : std::vector<std::string>{"b"}, last);
    made.simulations = predictions.simulations();
    return made;
  }

  OneJointRig rig;
  PredictionLadder ladder;
};

TEST(Descent, FindsTheValueOfTheRecordings) {
  const PredictionFit fit = SpringDescent().descend_from({0.1}).fit;
  ASSERT_TRUE(fit.valid);
  EXPECT_NEAR(fit.point.values(0), kDamping, 0.01);
}

TEST(Descent, FindsTheSameFromFarAway) {
  const SpringDescent spring;
  EXPECT_NEAR(spring.descend_from({9.0}).fit.point.values(0), spring.descend_from({0.1}).fit.point.values(0), 1e-3);
}

TEST(Descent, MovesTheStartsWithTheValues) {
  const SpringDescent spring;
  const PredictionFit fit = spring.descend_from({0.1}).fit;
  std::vector<Eigen::VectorXd> settled, smoothed;
  LadderPredictions predictions = spring.rig.predictions(spring.ladder);
  ASSERT_TRUE(predictions.residuals(fit.point, settled));
  ASSERT_TRUE(predictions.residuals(predictions.at_smoothed_starts(fit.point.values), smoothed));
  double of_settled = 0.0, of_smoothed = 0.0;
  for (std::size_t k = 0; k < settled.size(); ++k) {
    of_settled += settled[k].squaredNorm();
    of_smoothed += smoothed[k].squaredNorm();
  }
  EXPECT_LT(of_settled, of_smoothed);
}

/// A model that is right leaves the noise: no cost above that of a mean square of 1.
TEST(Descent, SaysWhatThePredictionsCost) {
  const SpringDescent spring;
  const PredictionFit fit = spring.descend_from({0.1}).fit;
  const double of_predictions = cost_at(spring.ladder.layout, fit.products, Eigen::VectorXd::Zero(1)).cost;
  EXPECT_NEAR(fit.cost, of_predictions + fit.bounds.cost_of_way(Eigen::VectorXd::Zero(1)), 1e-12);
  EXPECT_LT(fit.cost, 0.1);
  EXPECT_GT(fit.cost, -0.2);
}

TEST(Descent, StopsAtABound) {
  const PredictionFit fit = SpringDescent({damping(0.3)}).descend_from({0.1}).fit;
  EXPECT_EQ(fit.point.values(0), 0.3);
  EXPECT_EQ(fit.bounds.upper(0), 0.0) << "no way is left above";
  EXPECT_DOUBLE_EQ(fit.bounds.lower(0), -0.3);
}

TEST(Descent, LeavesAValueThatChangesNothingAtItsStart) {
  const SpringDescent spring({damping(), analytic::free_value("unused", 3.0, 0.0, 10.0)});
  const PredictionFit fit = spring.descend_from({0.1, 3.0}).fit;
  EXPECT_EQ(fit.point.values(1), 3.0);
  EXPECT_NEAR(fit.point.values(0), kDamping, 0.01);
}

TEST(Descent, SavesSimulationsWithTheDerivativesOfASimilarModel) {
  const SpringDescent spring;
  const SpringDescent::Descended anew = spring.descend_from({0.1});
  const LikeModel like{anew.fit.by_starts, anew.fit.by_values, {"b"}};
  const SpringDescent::Descended again = spring.descend_from({0.4}, like, LastSteps::as_it_is);
  ASSERT_TRUE(again.fit.valid);
  EXPECT_NEAR(again.fit.point.values(0), anew.fit.point.values(0), 5e-3);
  EXPECT_LT(again.simulations, anew.simulations / 2);
}

TEST(Descent, IsNotValidWhereTheStartCannotBeSimulated) {
  const SpringDescent spring({damping()}, [](std::span<const double> values, double q, double v, double u) {
    return values[0] > 5.0 ? std::nan("") : damped_spring(values, q, v, u);
  });
  EXPECT_FALSE(spring.descend_from({6.0}).fit.valid);
  EXPECT_TRUE(spring.descend_from({4.0}).fit.valid);
}

}  // namespace
}  // namespace lacuna
