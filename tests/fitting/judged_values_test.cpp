#include "fitting/judged_values.h"

#include "fitting/made_problem.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna::judged_values_test {
namespace {

using namespace lacuna::analytic;

/// The spring, which cannot be simulated with a damping above 5/s.
double fragile_spring(std::span<const double> p, double q, double v, double u) {
  return p[0] > 5.0 ? std::nan("") : spring(p, q, v, u);
}

/// Its whole recording as the last stage of a fit, which is given values.
class ValueJudgeTest : public testing::Test {
 protected:
  JudgedValues judged(double damping) const {
    const ValueJudge judge{made_.predictor, made_.states,     made_.space, made_.noise, 0.0,
                           made_.problem,   {RobustLoss{3.0}}};
    return judge.judge("given", {damping});
  }

  MadeProblem made_{std::make_unique<OneJointModel>(fragile_spring), spring_definition(), {spring_trial(kNoise, 1)}};
};

TEST_F(ValueJudgeTest, FindsTheRightValuesBetterThanOthers) {
  const JudgedValues right = judged(0.5);
  EXPECT_EQ(right.name, "given");
  EXPECT_EQ(right.candidate.values(0), 0.5) << "held";
  EXPECT_LT(right.objective(), judged(0.4).objective());
  EXPECT_LT(right.objective(), judged(0.6).objective());
}

/// Per reading: a whitened square of a right model is one.
TEST_F(ValueJudgeTest, CountsPerReading) { EXPECT_NEAR(judged(0.5).objective(), 1.0, 0.15); }

TEST_F(ValueJudgeTest, FindsNothingGoodAboutValuesThatCannotBeSimulated) {
  EXPECT_TRUE(std::isinf(judged(6.0).objective()));
}

TEST_F(ValueJudgeTest, TakesValuesOutsideTheirBoundsForTheBounds) {
  made_.space = ParameterSpace({free_value("joint.hinge.damping", 0.1, 0.0, 0.6)});
  EXPECT_EQ(judged(3.0).objective(), judged(0.6).objective());
}

}  // namespace
}  // namespace lacuna::judged_values_test
