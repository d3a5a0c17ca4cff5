#include "baselines/acceleration_balance.h"
#include "baselines/effective_bic.h"
#include "baselines/zero_phase.h"

#include "bench/bench_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace hidden_effects {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kInterval = 0.005;  ///< s

std::vector<double> tone(double frequency, std::size_t samples) {
  std::vector<double> x(samples);
  for (std::size_t k = 0; k < samples; ++k) x[k] = std::sin(kTurn * frequency * kInterval * static_cast<double>(k));
  return x;
}

TEST(ZeroPhase, ScalesAToneAndDoesNotDelayIt) {
  constexpr double kCutoff = 8.0, kFrequency = 10.0;  // Hz
  const std::vector<double> x = tone(kFrequency, 1000), y = zero_phase(x, kInterval, kCutoff);
  const double ratio = std::tan(0.5 * kTurn * kFrequency * kInterval) / std::tan(0.5 * kTurn * kCutoff * kInterval);
  const double gain = 1.0 / (1.0 + std::pow(ratio, 4));  // of a Butterworth filter of second order, both ways
  for (std::size_t k = 200; k < 800; ++k) EXPECT_NEAR(y[k], gain * x[k], 1e-6);
}

TEST(Bandwidth, IsWhereTonesEndAndNoiseBegins) {
  std::vector<double> x = tone(1.0, 1000);
  for (double frequency = 2.0; frequency <= 6.0; frequency += 1.0)
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += tone(frequency, x.size())[k];
  bench::Normal normal(3);
  for (double& value : x) value += 1e-3 * normal();
  const double found = bandwidth({x}, kInterval, 1.0, 90.0);
  EXPECT_GT(found, 6.0);
  EXPECT_LT(found, 9.0);
}

TEST(EffectiveCount, IsThatOfAFirstOrderProcess) {
  constexpr Eigen::Index kCount = 40000;
  bench::Normal normal(5);
  Eigen::VectorXd white(kCount), coloured(kCount);
  double x = 0.0;
  for (Eigen::Index k = 0; k < kCount; ++k) {
    white[k] = normal();
    coloured[k] = x = 0.8 * x + white[k];
  }
  EXPECT_NEAR(effective_count({coloured}), kCount * (1.0 - 0.8) / (1.0 + 0.8), 0.15 * kCount / 9.0);
  EXPECT_NEAR(effective_count({white}), kCount, 0.03 * kCount);
}

/// A trial of the arm with friction, as it went, and its inverse dynamics with the friction's torque as given.
double share_unbalanced(double torque) {
  const Rig rig = two_link_arm();
  const PlantModel model{rig.nominal, {}, {{&law_kind("viscous_friction"), 0}}};
  Excitation excitation;
  excitation.commands = commands(rig, 0, 5.0, 3);
  const Eigen::VectorXd values = Eigen::VectorXd::Constant(1, 0.2);
  Simulation plant(model.spec_at(values), model.laws_at(values), excitation, kFitStep);
  const Motion fine = simulate(plant, {Coordinates::Zero(2), Coordinates::Zero(2)}, excitation.samples(), 1);
  RecordedMotion motion;
  const auto stride = static_cast<std::size_t>(fine.steps_a_sample);
  for (std::size_t j = 0; j < 2; ++j) {
    std::vector<double> position, velocity, acceleration;
    for (std::size_t k = 0; k < fine.position[j].size(); k += stride) {
      const std::size_t before = k < stride ? k : k - stride / 2,
                        after = std::min(k + stride / 2, fine.position[j].size() - 1);
      position.push_back(fine.position[j][k]);
      velocity.push_back(fine.velocity[j][k]);
      acceleration.push_back((fine.velocity[j][after] - fine.velocity[j][before]) /
                             (static_cast<double>(after - before) * fine.interval));
    }
    motion.position.push_back(position);
    motion.velocity.push_back(velocity);
    motion.acceleration.push_back(acceleration);
  }
  const Eigen::MatrixXd left =
      acceleration_balance(model, Eigen::VectorXd::Constant(1, torque), excitation, motion).middleRows(1, 990);
  const Eigen::Map<const Eigen::VectorXd> elbow(motion.acceleration[1].data() + 1, 990);
  return left.col(1).norm() / elbow.norm();
}

TEST(AccelerationBalance, IsZeroForTheRightModelOnly) {
  EXPECT_LT(share_unbalanced(0.2), 0.01);
  EXPECT_GT(share_unbalanced(0.0), 0.1);
}

TEST(AccelerationBalance, IsNotToldByJointsBeforeAnElasticTransmission) {
  const Rig rig = servo_pendulum();
  const PlantModel model{rig.nominal, {}, {{&law_kind("joint_compliance"), 0}}};
  Excitation excitation;
  excitation.commands = {std::vector<double>(10, 0.0)};
  const std::vector<std::vector<double>> still{std::vector<double>(10, 0.0)};
  EXPECT_EQ(acceleration_balance(model, Eigen::Vector2d(50.0, 0.1), excitation, {still, still, still}).size(), 0);
}

}  // namespace
}  // namespace hidden_effects
