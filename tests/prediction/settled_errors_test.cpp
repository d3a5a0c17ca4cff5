#include "prediction/settled_errors.h"

#include "prediction/one_joint_rig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

std::vector<FreeValue> damping() { return {analytic::free_value("b", 0.1, 0.0, 10.0)}; }

std::optional<Eigen::VectorXd> errors_of(const OneJointRig& rig, const PredictionLadder& ladder, double value) {
  LadderPredictions predictions = rig.predictions(ladder);
  return settled_errors(predictions, rig.at({value}));
}

TEST(SettledErrors, OfARightModelAreOneAtEveryLength) {
  const OneJointRig rig(damped_spring, damping(), {0.5}, {20.0});
  const std::optional<Eigen::VectorXd> errors = errors_of(rig, rig.ladder({0.5, 2.0}), 0.5);
  ASSERT_TRUE(errors);
  ASSERT_EQ(errors->size(), 2);
  EXPECT_NEAR((*errors)(0), 1.0, 0.15);
  EXPECT_NEAR((*errors)(1), 1.0, 0.15);
}

/// Readings that are half as noisy as was assumed.
TEST(SettledErrors, AreSquaresInUnitsOfTheNoise) {
  OneJointRig rig(damped_spring, damping(), {0.5}, {20.0});
  rig.noise[0].deviation *= 2.0;
  const std::optional<Eigen::VectorXd> errors = errors_of(rig, rig.ladder({0.5}), 0.5);
  ASSERT_TRUE(errors);
  EXPECT_NEAR((*errors)(0), 0.25, 0.05);
}

/// A wrong damping is worse the longer one predicts, and the values do not move to mend it.
TEST(SettledErrors, OfAWrongValueGrowWithTheLength) {
  const OneJointRig rig(damped_spring, damping(), {0.5}, {20.0});
  const std::optional<Eigen::VectorXd> errors = errors_of(rig, rig.ladder({0.5, 2.0}), 1.5);
  ASSERT_TRUE(errors);
  EXPECT_GT((*errors)(0), 3.0);
  EXPECT_GT((*errors)(1), 3.0 * (*errors)(0));
}

TEST(SettledErrors, AreZeroWhereNothingIsRead) {
  OneJointRig rig(damped_spring, damping(), {0.5});
  rig.noise.push_back({"speed", "rad/s", 1.0, ""});
  const std::optional<Eigen::VectorXd> errors = errors_of(rig, rig.ladder({0.5}), 0.5);
  ASSERT_TRUE(errors);
  ASSERT_EQ(errors->size(), 2);
  EXPECT_GT((*errors)(0), 0.5);
  EXPECT_EQ((*errors)(1), 0.0);
}

TEST(SettledErrors, AreNoneWhereAStretchCannotBeSimulated) {
  const OneJointRig rig([](std::span<const double> values, double q, double v,
                           double u) { return values[0] > 5.0 ? std::nan("") : damped_spring(values, q, v, u); },
                        damping(), {0.5});
  EXPECT_FALSE(errors_of(rig, rig.ladder({0.5}), 6.0));
}

}  // namespace
}  // namespace lacuna
