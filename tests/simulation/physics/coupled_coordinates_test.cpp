#include "simulation/ode/coupled_coordinates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace lacuna::ode {
namespace {

constexpr double kStep = 1e-3;
constexpr int kCount = 3;

CoupledCoordinates three(const Eigen::Matrix3d& inertia, const Eigen::Vector3d& push) {
  CoupledCoordinates coordinates(kCount, kStep, 3 * kCount);
  coordinates.inertia.topLeftCorner<kCount, kCount>() = inertia;
  coordinates.push.head<kCount>() = push;
  coordinates.offset.setZero();
  return coordinates;
}

Eigen::Vector3d settled(CoupledCoordinates coordinates, const std::vector<CoordinateLaw>& laws) {
  CoupledCoordinates::Column velocity = CoupledCoordinates::Column::Zero();
  coordinates.settle(laws, velocity);
  return velocity.head<kCount>();
}

const Eigen::Matrix3d kInertia{{2.0, 0.8, -0.3}, {0.8, 1.0, 0.1}, {-0.3, 0.1, 0.5}};

TEST(CoupledCoordinates, MoveFreelyWithoutLaws) {
  const Eigen::Vector3d free(0.7, -2.0, 0.1);
  EXPECT_LE((settled(three(kInertia, kInertia * free), {}) - free).norm(), 1e-14);
}

/// The definition: momentum gained = step · the forces that the laws give at these velocities.
TEST(CoupledCoordinates, KeepAllLaws) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> about(-1.0, 1.0), within(0.0, 1.0);
  for (int trial = 0; trial < 300; ++trial) {
    const Eigen::Matrix3d root = Eigen::Matrix3d::NullaryExpr([&] { return about(random); });
    const Eigen::Matrix3d inertia = root * root.transpose() + 0.01 * Eigen::Matrix3d::Identity();
    const Eigen::Vector3d push = Eigen::Vector3d::NullaryExpr([&] { return about(random); });
    std::vector<CoordinateLaw> laws;
    for (std::size_t i = 0; i < 9; ++i) {
      CoordinateLaw law{.target = about(random), .compliance = 1e-5 + 1e-3 * within(random), .coordinate = i % 3};
      if (i < 6) law.lower = -500.0 * within(random), law.upper = 500.0 * within(random);
      laws.push_back(law);
    }
    const Eigen::Vector3d velocity = settled(three(inertia, push), laws);
    Eigen::Vector3d missing = inertia * velocity - push;
    for (const CoordinateLaw& law : laws) {
      const auto i = static_cast<Eigen::Index>(law.coordinate);
      missing[i] -= kStep * std::clamp((law.target - velocity[i]) / law.compliance, law.lower, law.upper);
    }
    EXPECT_LE(missing.norm(), 1e-12) << "trial " << trial;
  }
}

TEST(CoupledCoordinates, DryFrictionHoldsOneAndLetsAnotherGo) {
  std::vector<CoordinateLaw> friction;
  for (std::size_t i = 0; i < kCount; ++i)
    friction.push_back({.compliance = 1e-10, .lower = -3.0, .upper = 3.0, .coordinate = i});
  // Alone, the middle one would get away: what it gains beyond the friction's 3 N moves it.
  const Eigen::Vector3d push = kStep * Eigen::Vector3d(0.5, 4.0, -0.2);
  const Eigen::Vector3d velocity = settled(three(kInertia, push), friction);
  EXPECT_NEAR(velocity[0], 0.0, 1e-9);
  EXPECT_NEAR(velocity[1], kStep * (4.0 - 3.0) / kInertia(1, 1), 1e-9);
  EXPECT_NEAR(velocity[2], 0.0, 1e-9);
}

TEST(CoupledCoordinates, LawsKnowVelocitiesByTheirOffset) {
  CoupledCoordinates coordinates = three(kInertia, Eigen::Vector3d::Zero());
  coordinates.offset.head<kCount>() = Eigen::Vector3d(0.2, 0.0, -0.1);
  EXPECT_LE((settled(coordinates, {}) - Eigen::Vector3d(0.2, 0.0, -0.1)).norm(), 1e-15);
}

}  // namespace
}  // namespace lacuna::ode
