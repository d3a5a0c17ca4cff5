#include "diagnosis/refit/normal_equations.h"

#include "kernels/dense.h"

#include <Eigen/QR>

namespace lacuna {

void NormalEquations::add(const WeightedSegment& segment) {
  dense::add_product(1.0, segment.values.transpose(), segment.values, gram);
  score += segment.values.transpose() * segment.residual;
}

void NormalEquations::add(const NormalEquations& other) {
  gram += other.gram;
  score += other.score;
}

NormalEquations no_equations(Eigen::Index values) {
  return {Eigen::MatrixXd::Zero(values, values), Eigen::VectorXd::Zero(values)};
}

NormalEquations normal_equations(const std::vector<WeightedSegment>& segments, Eigen::Index values) {
  NormalEquations equations = no_equations(values);
  for (const WeightedSegment& segment : segments) equations.add(segment);
  return equations;
}

double cost_of_moving(const NormalEquations& equations, const std::vector<Eigen::Index>& moved,
                      const Eigen::VectorXd& way, const std::vector<Eigen::Index>& others) {
  Eigen::MatrixXd left = equations.gram(moved, moved);
  if (!others.empty()) {
    const Eigen::MatrixXd own = equations.gram(others, others), mixed = equations.gram(moved, others);
    left -= mixed * own.completeOrthogonalDecomposition().solve(mixed.transpose());
  }
  return 2.0 * equations.score(moved).dot(way) + way.dot(left * way);
}

}  // namespace lacuna
