#include "prediction/settled_errors.h"

namespace lacuna {
namespace {

constexpr int kMostMoves = 3;             ///< of the starts
constexpr double kNoLonger = 1.0 - 1e-3;  ///< of the residual: a smaller move is the last one

LinearPrediction by_starts_alone(LadderPredictions& predictions, const PredictionPoint& point,
                                 const std::vector<Eigen::VectorXd>& residuals) {
  LinearPrediction linear;
  linear.stretches.resize(residuals.size());
  for (std::size_t k = 0; k < residuals.size(); ++k) linear.stretches[k].values.resize(residuals[k].size(), 0);
  predictions.linearise_starts(point, residuals, linear);
  return linear;
}

}  // namespace

std::optional<Eigen::VectorXd> settled_errors(LadderPredictions& predictions, const Eigen::VectorXd& values) {
  const CellLayout& layout = predictions.ladder().layout;
  const Eigen::VectorXd none(0);
  PredictionPoint point = predictions.at_smoothed_starts(values);
  std::optional<LinearCost> least;
  std::vector<Eigen::VectorXd> residuals;
  for (int move = 0; move <= kMostMoves && predictions.residuals(point, residuals); ++move) {
    const LinearPrediction linear = by_starts_alone(predictions, point, residuals);
    LinearCost left = cost_at(layout, linear.products, none);
    const bool is_less = !least || left.mean_square.sum() < kNoLonger * least->mean_square.sum();
    if (is_less) least = std::move(left);
    if (!is_less) break;
    point.starts = moved_starts(predictions.ladder(), linear, none);
  }
  if (!least) return std::nullopt;
  return least->mean_square;
}

}  // namespace lacuna
