#pragma once

#include <Eigen/Core>

#include <numbers>

namespace hidden_effects {

/// rad
inline constexpr double kTurn = 2.0 * std::numbers::pi;

/// Joints, and rotors behind elastic transmissions: as many coordinates as a plant of this benchmark has at most. From
/// 8 on, Eigen would multiply such matrices in another order, and the digits of all cases would change.
inline constexpr int kMostCoordinates = 7;

/// One number a coordinate, without allocation: rad or m, N·m or N, ...
using Coordinates = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMostCoordinates, 1>;
using CoordinateMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMostCoordinates, kMostCoordinates>;

/// (x, z) in the vertical plane in which every mechanism here moves, m or N; x forward, z up.
using InPlane = Eigen::Vector2d;

/// `r` turned by `angle` rad about y: z towards x, as a right-handed hinge about y turns it.
inline InPlane turned(const InPlane& r, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * r.x() + s * r.y(), c * r.y() - s * r.x()};
}

/// The derivative of `turned` with respect to its angle, of an already turned vector.
inline InPlane quarter_turned(const InPlane& r) { return {r.y(), -r.x()}; }

}  // namespace hidden_effects
