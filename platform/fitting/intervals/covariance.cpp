#include "fitting/intervals/covariance.h"

#include "foundation/statistics.h"
#include "fitting/shooting/reduced_rows.h"
#include "fitting/shooting/residual_memory.h"
#include "fitting/shooting/time_blocks.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kBlockCorrelations = 6.0;  ///< length of a block in correlation times
constexpr int kLeastBlocks = 12;            ///< with fewer, their own spread would be poorly known
constexpr int kMostBlocks = 40;
constexpr double kRounding = 1e-10;  ///< eigenvalues below this share of the largest are rounding errors of differences
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kTakesPart = 0.1;  ///< of a direction's largest component

/// The blocks over which scores are summed: several correlation times long, but not too few; and no more than needed
/// for a fair estimate, because the correlation time misses a slow disturbance below the sensor's noise.
TimeBlocks choose_blocks(const ShootingProblem& problem, Eigen::Index values, Uncertainty& result) {
  const double duration = scored_duration(problem);
  const int fewest = std::max(kLeastBlocks, 3 * static_cast<int>(values));
  const double longest = duration / fewest;
  const double wanted = kBlockCorrelations * result.correlation_time;
  result.few_blocks = wanted > longest;
  result.enough_data = fewest * wanted;
  TimeBlocks blocks(problem, std::min(std::max(wanted, duration / kMostBlocks), longest));
  result.blocks = blocks.count();
  return blocks;
}

Eigen::MatrixXd block_scores(const std::vector<ReducedRows>& rows, const TimeBlocks& blocks) {
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(rows.front().sensitivity.cols(), blocks.count());
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (Eigen::Index row = 0; row < rows[k].score.size(); ++row)
      sums.col(blocks.of(k, row)) += rows[k].sensitivity.row(row).transpose() * rows[k].score(row);
  return sums;
}

double total_power(const std::vector<ReducedRows>& rows) {
  double sum = 0.0;
  for (const ReducedRows& segment : rows) sum += segment.score.squaredNorm();
  return sum;
}

/// The change that a relative change of 1 means: the value itself, or for a small value the change that moves the
/// prediction by as much as the residual.
Eigen::VectorXd typical_sizes(const ParameterSpace& space, const FitPoint& point, const Eigen::MatrixXd& information,
                              double power) {
  Eigen::VectorXd sizes = Eigen::VectorXd::Ones(space.size());
  for (Eigen::Index j = 0; j < space.size(); ++j) {
    if (space.logarithmic(j)) continue;
    const double shows = information(j, j) > 0.0 ? std::sqrt(power / information(j, j)) : 0.0;
    sizes(j) = std::max(std::abs(point.values(j)), std::min(shows, space.upper()(j) - space.lower()(j)));
    if (sizes(j) == 0.0) sizes(j) = space.upper()(j) - space.lower()(j);
  }
  return sizes;
}

void note_undetermined(const Eigen::VectorXd& direction, const std::vector<Eigen::Index>& free, Uncertainty& result) {
  Eigen::VectorXd full = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(result.determined.size()));
  full(free) = direction;
  for (Eigen::Index j = 0; j < full.size(); ++j)
    if (std::abs(full(j)) > kTakesPart * full.cwiseAbs().maxCoeff())
      result.determined[static_cast<std::size_t>(j)] = false;
  result.undetermined.push_back(std::move(full));
}

/// The inverse of the information in relative changes, without the directions that the data do not determine; these go
/// to `result`.
Eigen::MatrixXd determined_inverse(const Eigen::MatrixXd& relative, double variance,
                                   const std::vector<Eigen::Index>& free, Uncertainty& result) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(relative);
  const double rounding = kRounding * eigen.eigenvalues()(relative.rows() - 1);
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(relative.rows(), relative.cols());
  for (Eigen::Index i = 0; i < relative.rows(); ++i) {
    const double value = eigen.eigenvalues()(i);
    const Eigen::VectorXd direction = eigen.eigenvectors().col(i);
    if (value > rounding && std::sqrt(variance / value) < kUndetermined)
      inverse += direction * direction.transpose() / value;
    else
      note_undetermined(direction, free, result);
  }
  return inverse;
}

}  // namespace

Uncertainty uncertainty(const ShootingProblem& problem, const ParameterSpace& space, const FitPoint& point,
                        const std::vector<Eigen::VectorXd>& residuals, const std::vector<SegmentJacobian>& jacobians,
                        const RobustLoss& loss, const std::vector<bool>& at_bound) {
  const std::vector<ReducedRows> rows = reduce(problem, residuals, jacobians, loss);
  const Eigen::MatrixXd all = information(rows);
  Uncertainty result;
  std::vector<Eigen::VectorXd> scores_by_segment;
  for (const ReducedRows& segment : rows) scores_by_segment.push_back(segment.score);
  const ResidualMemory memory = residual_memory(problem, scores_by_segment);
  result.correlation_time = memory.time;
  result.sizes = typical_sizes(space, point, all, total_power(rows));
  result.determined.assign(at_bound.size(), true);
  result.covariance = Eigen::MatrixXd::Constant(space.size(), space.size(), kUnknown);
  result.inverse_information = Eigen::MatrixXd::Zero(space.size(), space.size());
  const TimeBlocks blocks = choose_blocks(problem, space.size(), result);

  std::vector<Eigen::Index> free;
  for (Eigen::Index j = 0; j < space.size(); ++j)
    if (!at_bound[static_cast<std::size_t>(j)]) free.push_back(j);
  if (free.empty()) return result;
  const Eigen::VectorXd scale = result.sizes(free);
  const Eigen::MatrixXd relative = scale.asDiagonal() * all(free, free) * scale.asDiagonal();
  // The actual variance of a sum of scores: their mean square × the number of samples that vary together.
  const double variance = total_power(rows) / memory.effective_samples;
  const Eigen::MatrixXd bread =
      scale.asDiagonal() * determined_inverse(relative, variance, free, result) * scale.asDiagonal();
  result.inverse_information(free, free) = bread;

  const int degrees = std::max(1, result.blocks - static_cast<int>(free.size()));
  result.quantile = within_95_of_students_t(degrees);
  const Eigen::MatrixXd scores = block_scores(rows, blocks)(free, Eigen::all);
  result.covariance(free, free) =
      bread * (scores * scores.transpose()) * bread * (static_cast<double>(result.blocks) / degrees);
  for (const Eigen::Index j : free) {
    if (result.determined[static_cast<std::size_t>(j)]) continue;
    result.covariance.row(j).setConstant(kUnknown);
    result.covariance.col(j).setConstant(kUnknown);
  }
  return result;
}

}  // namespace lacuna
