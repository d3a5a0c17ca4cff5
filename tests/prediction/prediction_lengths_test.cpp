#include "prediction/prediction_lengths.h"

#include "prediction/one_joint_rig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

std::vector<FreeValue> damping() { return {analytic::free_value("b", 0.5, 0.0, 10.0)}; }

std::vector<double> lengths_of(const OneJointRig& rig, double value = 0.5) {
  return prediction_lengths(rig.source(), rig.space, {value});
}

/// A damped spring forgets its start: predictions of the whole recording mean something.
TEST(PredictionLengths, AreFiveFromTenSamplesOn) {
  const std::vector<double> lengths = lengths_of(OneJointRig(damped_spring, damping(), {0.5}, {8.0, 4.0}));
  ASSERT_EQ(lengths.size(), 5U);
  EXPECT_NEAR(lengths.front(), 0.1, 1e-9);
  EXPECT_NEAR(lengths.back(), 8.0, 1e-9);
  for (std::size_t i = 1; i < lengths.size(); ++i)
    EXPECT_NEAR(lengths[i] / lengths[i - 1], std::pow(80.0, 0.25), 1e-9) << i;
}

/// What grows as e^(2 t) loses its start: an error of 5 mrad/s in the velocity is 0.5 rad after 3 s.
TEST(PredictionLengths, EndWhereTheStartIsLost) {
  const OneJointRig rig([](std::span<const double>, double q, double, double u) { return 4.0 * q + u; }, damping(),
                        {0.5}, {4.0});
  const std::vector<double> lengths = lengths_of(rig);
  EXPECT_NEAR(lengths.front(), 0.1, 1e-9);
  EXPECT_LT(lengths.back(), 3.0);
  EXPECT_GT(lengths.back(), 0.3);
}

/// Every second reading is missing.
TEST(PredictionLengths, CountTheSamplesThatWereRead) {
  const OneJointRig rig(damped_spring, damping(), {0.5}, {8.0});
  std::vector<Trial> trials = rig.trials;
  for (Eigen::Index i = 1; i < trials[0].measured.samples.rows(); i += 2)
    trials[0].measured.samples(i, 0) = std::nan("");
  const TrialPredictor predictor(rig.model, trials, {1});
  const StartStates states(rig.definition.structure.robot, predictor, rig.noise);
  const SmoothedStarts starts(states, predictor.trials());
  const LadderSource source{rig.definition.structure.robot, predictor, states, starts, rig.noise};
  EXPECT_NEAR(prediction_lengths(source, rig.space, {0.5}).front(), 0.2, 1e-9);
}

/// Their failure is found where they are used.
TEST(PredictionLengths, ReachThirtySamplesWhereNothingCanBeSimulated) {
  const auto failing = [](std::span<const double> values, double q, double v, double u) {
    return values[0] > 5.0 ? std::nan("") : damped_spring(values, q, v, u);
  };
  const std::vector<double> lengths = lengths_of(OneJointRig(failing, damping(), {0.5}), 6.0);
  EXPECT_NEAR(lengths.front(), 0.1, 1e-9);
  EXPECT_NEAR(lengths.back(), 0.3, 1e-9);
}

}  // namespace
}  // namespace lacuna
