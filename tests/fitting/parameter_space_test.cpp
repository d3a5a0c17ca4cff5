#include "fitting/shooting/parameter_space.h"

#include "fitting/analytic_models.h"
#include "fitting/fit.h"
#include "fitting/shooting/start_points.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

using namespace lacuna::analytic;

TEST(ParameterSpace, TakesTheLogarithmWhereDeclaredAndPositive) {
  const ParameterSpace space({free_value("a", 1.0, 0.01, 100.0, Scale::logarithmic),
                              free_value("b", 1.0, 0.0, 100.0, Scale::logarithmic), free_value("c", 1.0, -1.0, 1.0)});
  EXPECT_TRUE(space.logarithmic(0));
  EXPECT_FALSE(space.logarithmic(1));  // zero has no logarithm
  EXPECT_FALSE(space.logarithmic(2));
  EXPECT_DOUBLE_EQ(space.to_value(0, std::log(3.0)), 3.0);
  EXPECT_DOUBLE_EQ(space.slope(0, std::log(3.0)), 3.0);
  EXPECT_EQ(space.slope(1, 3.0), 1.0);
}

TEST(ParameterSpace, ClampsToTheBounds) {
  const ParameterSpace space({free_value("a", 1.0, 0.01, 100.0, Scale::logarithmic), free_value("c", 1.0, -1.0, 1.0)});
  const std::vector<double> values = space.to_values(space.to_coordinates({1000.0, -7.0}));
  EXPECT_DOUBLE_EQ(values[0], 100.0);
  EXPECT_EQ(values[1], -1.0);
}

TEST(Fit, OfALogarithmicValueFindsItOrdersAwayAndItsIntervalStaysPositive) {
  // A decay exp(−k t) with k = 0.5, searched from 50 within eight decades.
  const FormulaModel model([](std::span<const double> p, double t) { return std::exp(-p[0] * t); });
  const ModelDefinition definition = define({free_value("k", 50.0, 1e-4, 1e4, Scale::logarithmic)});
  const std::vector<Trial> trials = {record(model, {0.5}, regular_times(401, 100.0), {}, {}, 0.05, 3)};
  const FittedValue k = fit({definition, model, trials, {}}).values[0];
  EXPECT_NEAR(k.value, 0.5, 0.03);
  EXPECT_GT(k.lower_95, 0.0);
  EXPECT_LT(k.lower_95, 0.5);
  EXPECT_GT(k.upper_95, 0.5);
  EXPECT_NEAR(std::log(k.upper_95 / k.value), std::log(k.value / k.lower_95), 1e-9);
}

/// The starting points of a slider q'' = u − b q' whose friction starts at zero.
std::vector<Eigen::VectorXd> slider_starts(int count, std::uint64_t seed) {
  const OneJointModel model([](std::span<const double> p, double, double v, double u) { return u - p[0] * v; });
  const ModelDefinition definition = define({free_value("b", 0.0, 0.0, 1e4)}, one_joint_robot());
  const Trial trial = record(model, {0.5}, regular_times(801, 200.0), two_sines(4.0, 1.0), {{0.0}, {0.0}}, 1e-3, 3);
  const TrialPredictor predictor(model, {trial}, {1});
  const std::vector<ChannelNoise> noise = {{"angle", "rad", 1e-3, ""}};
  const StartStates states(one_joint_robot(), predictor, noise);
  const ParameterSpace space(definition.free);
  ShootingProblem problem(predictor, space, make_segments(predictor, states, 0.5, {0.0}), noise);
  return start_points(problem, space, definition.free, count, seed);
}

TEST(StartPoints, BeginWithTheModelsOwnAndOfferSizesThatTheDataShow) {
  const std::vector<Eigen::VectorXd> points = slider_starts(5, 1);
  ASSERT_EQ(points.size(), 5u);
  EXPECT_EQ(points[0](0), 0.0);
  for (std::size_t i = 1; i < points.size(); ++i) {  // the bounds reach to 1e4, the answer is 0.5
    EXPECT_GT(points[i](0), 0.01) << i;
    EXPECT_LT(points[i](0), 50.0) << i;
  }
}

TEST(StartPoints, AreTheSeeds) {
  EXPECT_EQ(slider_starts(5, 1), slider_starts(5, 1));
  EXPECT_NE(slider_starts(5, 1)[4], slider_starts(5, 2)[4]);
}

}  // namespace
}  // namespace lacuna
