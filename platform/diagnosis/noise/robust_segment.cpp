#include "diagnosis/noise/robust_segment.h"

#include <Eigen/QR>

namespace lacuna {
namespace {

constexpr int kMostStartSteps = 10;
constexpr double kSettled = 1e-6;  ///< of the deviance

double total(const RobustSegment& segment, const Eigen::VectorXd& residual) {
  double sum = residual.tail(residual.size() - segment.bins()).squaredNorm();
  for (Eigen::Index row = 0; row < segment.bins(); ++row) sum += kBinLoss.cost(residual(row));
  return sum;
}

}  // namespace

Eigen::VectorXd RobustSegment::weights(const Eigen::VectorXd& at) const {
  Eigen::VectorXd all = Eigen::VectorXd::Ones(at.size());
  for (Eigen::Index row = 0; row < bins(); ++row) all(row) = kBinLoss.weight(at(row));
  return all;
}

WeightedSegment weighted(const RobustSegment& segment, const Eigen::VectorXd& weights) {
  const Eigen::VectorXd roots = weights.cwiseSqrt();
  WeightedSegment result{roots.asDiagonal() * segment.residual, roots.asDiagonal() * segment.values, {}};
  const Eigen::Index states = segment.state.cols();
  result.start_follows = Eigen::MatrixXd::Zero(states, segment.values.cols());
  if (states == 0) return result;
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(roots.asDiagonal() * segment.state);
  const Eigen::MatrixXd basis = qr.householderQ() * Eigen::MatrixXd::Identity(roots.size(), states);
  result.start_follows = qr.solve(result.values);
  result.start_follows = -result.start_follows;
  result.residual -= basis * (basis.transpose() * result.residual);
  result.values -= basis * (basis.transpose() * result.values);
  return result;
}

Eigen::VectorXd at_best_start(const RobustSegment& segment, Eigen::VectorXd residual) {
  if (segment.state.cols() == 0) return residual;
  double least = total(segment, residual);
  for (int step = 0; step < kMostStartSteps; ++step) {  // weighted least squares, which never raises the loss
    const Eigen::VectorXd roots = segment.weights(residual).cwiseSqrt();
    const Eigen::MatrixXd state = roots.asDiagonal() * segment.state;
    residual -= segment.state * state.householderQr().solve(Eigen::VectorXd(roots.asDiagonal() * residual));
    const double now = total(segment, residual);
    const bool settled = least - now <= kSettled * least;
    least = now;
    if (settled) break;
  }
  return residual;
}

Eigen::VectorXd block_deviances(const RobustSegment& segment, const Eigen::VectorXd& residual) {
  const Eigen::VectorXd best = at_best_start(segment, residual);
  Eigen::VectorXd deviances = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(segment.blocks()));
  for (Eigen::Index row = 0; row < segment.bins(); ++row)
    deviances(static_cast<Eigen::Index>(segment.block_of[static_cast<std::size_t>(row)])) += kBinLoss.cost(best(row));
  const Eigen::Index of_start = best.size() - segment.bins() - segment.priors_of_values;
  deviances(0) += best.segment(segment.bins(), of_start).squaredNorm();
  return deviances;
}

}  // namespace lacuna
