#include "diagnosis/rough_predictor.h"

#include "diagnosis/cut_trials.h"
#include "diagnosis/recorded_pendulum.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

/// The pendulum with a free mass and `substeps`, cut into segments of a second.
class RoughDerivatives : public testing::Test {
 protected:
  void prepare(int substeps) {
    rig_.definition.engine.substeps = substeps;
    rig_.definition.structure.parameters = {{"body.arm.mass", 0.1, 2.0}};
    rig_.definition.free = {{.address = "body.arm.mass", .unit = "kg", .lower = 0.1, .upper = 2.0, .start = 0.5}};
    rig_.model = compile(rig_.definition.structure, rig_.definition.engine);
    rig_.values = {0.5};
    base_ = cut_trials({.definition = rig_.definition,
                        .model = *rig_.model,
                        .trials = rig_.trials,
                        .values = rig_.values,
                        .segment = 1.0});
    predictor_ = std::make_unique<TrialPredictor>(*rig_.model, base_.trials, 1);
    space_ = std::make_unique<ParameterSpace>(rig_.definition.free);
    problem_ = std::make_unique<ShootingProblem>(*predictor_, *space_, base_.segments, base_.noise);
    point_ = {space_->to_coordinates(rig_.values), base_.states};
    ASSERT_TRUE(problem_->residuals(point_, residuals_));
  }

  std::vector<SegmentJacobian> derivatives() {
    std::vector<SegmentJacobian> jacobians;
    problem_->linearize(point_, residuals_, jacobians);
    return jacobians;
  }

  RecordedPendulum rig_;
  BaseSolution base_;
  std::unique_ptr<TrialPredictor> predictor_;
  std::unique_ptr<ParameterSpace> space_;
  std::unique_ptr<ShootingProblem> problem_;
  FitPoint point_;
  std::vector<Eigen::VectorXd> residuals_;
};

double relative_change(const Eigen::MatrixXd& from, const Eigen::MatrixXd& to) {
  return (to - from).norm() / from.norm();
}

TEST_F(RoughDerivatives, AreThoseOfManySubstepsToAFewPercent) {
  prepare(20);
  const std::vector<SegmentJacobian> fine = derivatives();
  const RoughPredictor rough(rig_.definition, base_, 1);
  ASSERT_NE(rough.predictor(), nullptr);
  problem_->difference_by(rough.predictor());
  const std::vector<SegmentJacobian> coarse = derivatives();
  for (std::size_t k = 0; k < fine.size(); ++k) {
    EXPECT_LT(relative_change(fine[k].values, coarse[k].values), 0.05);
    EXPECT_LT(relative_change(fine[k].state, coarse[k].state), 0.05);
    EXPECT_NE(fine[k].values, coarse[k].values);
  }
}

TEST_F(RoughDerivatives, ByStatesAloneAreTheSame) {
  prepare(8);
  const std::vector<SegmentJacobian> all = derivatives();  // finds the steps, too
  std::vector<SegmentJacobian> states;
  problem_->linearize_states(point_, residuals_, states);
  for (std::size_t k = 0; k < all.size(); ++k) {
    EXPECT_EQ(states[k].values.cols(), 0);
    EXPECT_EQ(states[k].state, all[k].state);
  }
}

TEST_F(RoughDerivatives, AreThoseOfTheProblemWhereCoarseStepsCannotBeSimulated) {
  prepare(8);
  const std::vector<SegmentJacobian> own = derivatives();
  ModelDefinition wild = rig_.definition;
  wild.structure.robot.bodies.front().com = {0.0, 0.0, 1e200};
  const RoughPredictor rough(wild, base_, 1);
  problem_->difference_by(rough.predictor());
  const std::vector<SegmentJacobian> fallen_back = derivatives();
  for (std::size_t k = 0; k < own.size(); ++k) EXPECT_EQ(own[k].values, fallen_back[k].values);
}

TEST_F(RoughDerivatives, HaveNoPredictorWhereStepsAreCoarseOrImpactsDecide) {
  prepare(2);
  EXPECT_EQ(RoughPredictor(rig_.definition, base_, 1).predictor(), nullptr);
  rig_.definition.engine.substeps = 20;
  EXPECT_NE(RoughPredictor(rig_.definition, base_, 1).predictor(), nullptr);
  base_.free_run = true;
  EXPECT_EQ(RoughPredictor(rig_.definition, base_, 1).predictor(), nullptr);
}

int substeps_for_differences(int own, bool may_touch = false) {
  ModelDefinition definition;
  definition.engine.substeps = own;
  definition.structure.robot.contact.ground = may_touch;
  definition.structure.robot.bodies.emplace_back();
  definition.structure.robot.bodies.back().shapes.emplace_back();
  return for_differences(definition).substeps;
}

TEST(ForDifferences, TakesAQuarterOfTheSubstepsButTwo) {
  EXPECT_EQ(substeps_for_differences(20), 5);
  EXPECT_EQ(substeps_for_differences(4), 2);
  EXPECT_EQ(substeps_for_differences(2), 2);
  EXPECT_EQ(substeps_for_differences(1), 1);
}

TEST(ForDifferences, LeavesTheStepsWhereABodyMayHitTheGround) { EXPECT_EQ(substeps_for_differences(20, true), 20); }

}  // namespace
}  // namespace lacuna
