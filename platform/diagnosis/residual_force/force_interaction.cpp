#include "diagnosis/residual_force/force_interaction.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

std::array<double, 2> middle_and_half(const std::vector<Eigen::VectorXd>& values) {
  double low = INFINITY, high = -INFINITY;
  for (const Eigen::VectorXd& one : values) {
    if (one.size() == 0) continue;
    low = std::min(low, one.minCoeff());
    high = std::max(high, one.maxCoeff());
  }
  if (!(low < high)) return {0.0, 1.0};
  return {0.5 * (low + high), 0.5 * (high - low)};
}

double legendre(int degree, double value, const std::array<double, 2>& range) {
  const double x = std::clamp((value - range[0]) / range[1], -1.0, 1.0);
  return std::legendre(static_cast<unsigned>(degree), x);
}

}  // namespace

ForceInteraction::ForceInteraction(const JointMotion& motion)
    : positions_(middle_and_half(motion.position)), velocities_(middle_and_half(motion.velocity)) {
  Positions position = Positions::Zero();
  Velocities velocity = Velocities::Zero();
  double count = 0.0;
  for (std::size_t k = 0; k < motion.position.size(); ++k)
    for (Eigen::Index p = 0; p < motion.position[k].size(); ++p) {
      position += of_position(motion.position[k](p));
      velocity += of_velocity(motion.velocity[k](p));
      count += 1.0;
    }
  mean_of_position_ = position / std::max(count, 1.0);
  mean_of_velocity_ = velocity / std::max(count, 1.0);
}

ForceInteraction::Positions ForceInteraction::of_position(double q) const {
  Positions all;
  for (int i = 0; i < kPositions; ++i) all(i) = legendre(i + 1, q, positions_) - mean_of_position_(i);
  return all;
}

ForceInteraction::Velocities ForceInteraction::of_velocity(double v) const {
  Velocities all;
  for (int i = 0; i < kVelocities; ++i) all(i) = legendre(i + 1, v, velocities_);
  all(kVelocities) = v > 0.0 ? 1.0 : v < 0.0 ? -1.0 : 0.0;
  return all - mean_of_velocity_;
}

Eigen::Vector<double, ForceInteraction::kCount> ForceInteraction::at(double q, double v) const {
  const Eigen::Matrix<double, kPositions, kVelocities + 1> products = of_position(q) * of_velocity(v).transpose();
  return products.reshaped();
}

}  // namespace lacuna
