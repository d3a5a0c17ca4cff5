#include "fitting/shooting/held_values.h"

#include "fitting/analytic_models.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

using namespace lacuna::analytic;

/// A line beside a wave that has its share of slope: the line alone takes the slope of both.
class HeldValues : public testing::Test {
 protected:
  static double line_and_wave(std::span<const double> values, double t) {
    return values[0] * t + values[1] * std::sin(0.5 * t);
  }

  Eigen::VectorXd found(const std::vector<double>& from, const std::vector<Eigen::Index>& free) {
    const StartStates states({}, predictor_, noise_);
    ShootingProblem problem(predictor_, space_, make_segments(predictor_, states, 0.0, from), noise_);
    return fit_beside_held(problem, space_.to_coordinates(from), free, LeastSquaresOptions{});
  }

  static constexpr double kNoise = 1e-4;
  const FormulaModel model_{line_and_wave};
  const Trial trial_ = record(model_, {1.0, 2.0}, regular_times(401, 200.0), {}, {}, kNoise, 1);
  const TrialPredictor predictor_{model_, {trial_}, {1}};
  const ParameterSpace space_{
      {free_value("joint.hinge.damping", 0.0, -50.0, 50.0), free_value("effect.wave.size", 0.0, -50.0, 50.0)}};
  const std::vector<ChannelNoise> noise_ = sensor_noise({}, predictor_.trials());
};

TEST_F(HeldValues, StayWhereTheyAreAndTheOthersFitBestBesideThem) {
  const Eigen::VectorXd truth = space_.to_coordinates(std::vector{1.0, 2.0});
  const Eigen::VectorXd beside_truth = found({-7.0, 2.0}, {0});
  EXPECT_EQ(beside_truth(1), truth(1));
  EXPECT_NEAR(beside_truth(0), truth(0), 1e-3);

  const Eigen::VectorXd beside_none = found({-7.0, 0.0}, {0});
  EXPECT_EQ(space_.to_values(beside_none)[1], 0.0);
  EXPECT_GT(space_.to_values(beside_none)[0], 1.5);
}

TEST_F(HeldValues, AreNoneWhereAllAreFree) {
  const std::vector<double> all = space_.to_values(found({-7.0, 0.0}, {0, 1}));
  EXPECT_NEAR(all[0], 1.0, 1e-3);
  EXPECT_NEAR(all[1], 2.0, 1e-3);
}

}  // namespace
}  // namespace lacuna
