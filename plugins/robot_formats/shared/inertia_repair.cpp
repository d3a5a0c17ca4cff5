#include "inertia_repair.h"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace lacuna::robot_files {
namespace {

constexpr double kRounding = 1e-6;     ///< of the largest moment
constexpr double kThinnest = 1e-3;     ///< of the largest moment
constexpr double kUsualRadius = 0.05;  ///< m

}  // namespace

bool can_be(const Eigen::Matrix3d& inertia) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertia, Eigen::EigenvaluesOnly);
  const Eigen::Vector3d& moments = solver.eigenvalues();  // ascending
  return moments(0) > 0.0 && moments(2) <= (moments(0) + moments(1)) * (1.0 + kRounding);
}

Eigen::Matrix3d repaired(const Eigen::Matrix3d& inertia, double mass) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertia);
  Eigen::Vector3d moments = solver.eigenvalues();
  if (!(moments(2) > 0.0)) return 0.4 * mass * kUsualRadius * kUsualRadius * Eigen::Matrix3d::Identity();
  moments = moments.cwiseMax(kThinnest * moments(2));
  if (const double excess = moments(2) - moments(0) - moments(1); excess > 0.0) {
    const double each = excess / 3.0;
    moments += Eigen::Vector3d(each, each, -each);
  }
  return solver.eigenvectors() * moments.asDiagonal() * solver.eigenvectors().transpose();
}

}  // namespace lacuna::robot_files
