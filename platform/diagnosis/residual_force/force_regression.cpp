#include "diagnosis/residual_force/force_regression.h"

#include "kernels/dense.h"

#include <Eigen/Cholesky>

#include <cmath>
#include <numeric>

namespace lacuna {
namespace {

constexpr int kMostReweightings = 8;
constexpr double kSameWeight = 0.01;
constexpr double kSmallRidge = 1e-10;  ///< of each column's information, where columns can hardly be told apart

std::vector<Eigen::Index> inside_bounds(const Refit& fit) {
  std::vector<Eigen::Index> inside;
  for (std::size_t j = 0; j < fit.at_bound.size(); ++j)
    if (!fit.at_bound[j]) inside.push_back(static_cast<Eigen::Index>(j));
  return inside;
}

/// x of A x = b, A positive semidefinite.
Eigen::MatrixXd solve_scaled(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  const Eigen::VectorXd scale = a.diagonal().unaryExpr([](double x) { return x > 0.0 ? 1.0 / std::sqrt(x) : 1.0; });
  Eigen::MatrixXd scaled = scale.asDiagonal() * a * scale.asDiagonal();
  scaled.diagonal().array() += kSmallRidge;
  return scale.asDiagonal() * scaled.ldlt().solve(scale.asDiagonal() * b);
}

}  // namespace

ForceRegression::ForceRegression(const Refit& base, const std::vector<Eigen::MatrixXd>& factors,
                                 const std::vector<Eigen::MatrixXd>& columns, const Folds& folds)
    : folds_(&folds), count_(columns.front().cols()) {
  const Columns inside = inside_bounds(base);
  values_ = static_cast<Eigen::Index>(inside.size());
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const RobustSegment& of_base = base.segments[k];
    RobustSegment segment{of_base.residual, Eigen::MatrixXd::Zero(of_base.residual.size(), values_ + count_),
                          of_base.state, of_base.block_of, of_base.priors_of_values};
    segment.values.leftCols(values_) = of_base.values(Eigen::all, inside);
    auto forces = segment.values.topRightCorner(of_base.bins(), count_);
    forces = -columns[k];  // residual: measured less predicted
    dense::solve_lower(factors[k], forces);
    weights_.push_back(segment.weights(segment.residual));
    segments_.push_back(std::move(segment));
  }
  build();
  leave_to_values();
}

/// What values would take up of a force is left to them from the start: the fit is the same, and hardly seen forces do
/// not spoil its equations.
void ForceRegression::leave_to_values() {
  const Columns values = with_values({});
  seen_ = Eigen::VectorXd::Zero(count_);
  for (Eigen::Index i = 0; i < count_; ++i) {
    const double power = normals_.all.gram(values_ + i, values_ + i);
    if (power > 0.0) seen_(i) = power_beside(values_ + i, values) / power;
  }
  if (values.empty()) return;
  const Eigen::MatrixXd taken = solve_scaled(normals_.all.gram.topLeftCorner(values_, values_),
                                             normals_.all.gram.topRightCorner(values_, count_));
  for (RobustSegment& segment : segments_) segment.values.rightCols(count_) -= segment.values.leftCols(values_) * taken;
  build();
}

void ForceRegression::build() {
  normals_ = normals_of(segments_, weights_, *folds_);
  if (values_ == 0) return;
  const Eigen::MatrixXd told = normals_.all.gram.topLeftCorner(values_, values_);
  for (NormalEquations& without : normals_.without) {
    auto values = without.gram.topLeftCorner(values_, values_);
    values = least_kept(told, values);
  }
}

bool ForceRegression::settle(const Columns& forces, double ridge) {
  bool changed = false;
  const Columns all = with_values(forces);
  for (int time = 0; time < kMostReweightings; ++time) {
    const Eigen::VectorXd sizes = solution(normals_.all, all, ridge);
    double moved = 0.0;
    for (std::size_t k = 0; k < segments_.size(); ++k) {
      const Eigen::VectorXd now = segments_[k].weights(at_best_start(segments_[k], residual(k, all, sizes)));
      moved = std::max(moved, (now - weights_[k]).cwiseAbs().maxCoeff());
      weights_[k] = now;
    }
    if (moved == 0.0) break;
    changed = true;
    build();
    if (moved < kSameWeight) break;
  }
  return changed;
}

Eigen::VectorXd ForceRegression::held_out(const Columns& forces, double ridge) const {
  const Columns all = with_values(forces);
  std::vector<Eigen::VectorXd> sizes;
  for (const NormalEquations& without : normals_.without) sizes.push_back(solution(without, all, ridge));
  return lacuna::held_out(segments_, *folds_,
                          [&](std::size_t k, std::size_t fold) { return residual(k, all, sizes[fold]); });
}

Eigen::VectorXd ForceRegression::sizes(const Columns& forces, double ridge) const {
  return solution(normals_.all, with_values(forces), ridge).tail(static_cast<Eigen::Index>(forces.size()));
}

Eigen::MatrixXd ForceRegression::covariance(const Columns& forces, double ridge) const {
  const Eigen::MatrixXd known = information(normals_.all.gram, with_values(forces), ridge);
  const auto count = static_cast<Eigen::Index>(forces.size());
  return solve_scaled(known, Eigen::MatrixXd::Identity(known.rows(), known.cols())).bottomRightCorner(count, count);
}

double ForceRegression::share_beside(Eigen::Index force, const Columns& forces) const {
  const double alone = power_beside(values_ + force, with_values({}));
  return alone > 0.0 ? power_beside(values_ + force, with_values(forces)) / alone : 0.0;
}

/// Of a column, what others do not span.
double ForceRegression::power_beside(Eigen::Index column, const Columns& others) const {
  const double power = normals_.all.gram(column, column);
  if (others.empty()) return power;
  const Eigen::VectorXd mixed = normals_.all.gram(others, column);
  return power - mixed.dot(solve_scaled(Eigen::MatrixXd(normals_.all.gram(others, others)), mixed).col(0));
}

ForceRegression::Columns ForceRegression::with_values(const Columns& forces) const {
  Columns all(static_cast<std::size_t>(values_));
  std::iota(all.begin(), all.end(), Eigen::Index{0});
  for (const Eigen::Index force : forces) all.push_back(values_ + force);
  return all;
}

Eigen::MatrixXd ForceRegression::information(const Eigen::MatrixXd& gram, const Columns& all, double ridge) const {
  Eigen::MatrixXd known = gram(all, all);
  known.diagonal().tail(known.rows() - values_).array() += ridge;
  return known;
}

Eigen::VectorXd ForceRegression::solution(const NormalEquations& normal, const Columns& all, double ridge) const {
  if (all.empty()) return {};
  return -solve_scaled(information(normal.gram, all, ridge), Eigen::VectorXd(normal.score(all)));
}

Eigen::VectorXd ForceRegression::residual(std::size_t k, const Columns& all, const Eigen::VectorXd& sizes) const {
  return segments_[k].residual + segments_[k].values(Eigen::all, all) * sizes;
}

}  // namespace lacuna
