#include "fitting/covariance.h"

#include "fitting/correlation_time.h"
#include "fitting/reduced_rows.h"
#include "fitting/time_blocks.h"

#include <Eigen/Eigenvalues>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace lacuna {
namespace {

constexpr double kBlockCorrelations = 6.0;  ///< a block is so many correlation times long
constexpr int kLeastBlocks = 12;            ///< fewer would say little about their own spread
constexpr double kRounding = 1e-10;         ///< eigenvalues below this share of the largest are differences' rounding
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr double kTakesPart = 0.1;  ///< of a direction's largest component

/// Residuals of one trial and channel in the order of time.
struct Trace {
  std::vector<double> values;
  double first = 0.0, last = 0.0;
  double interval() const { return values.size() > 1 ? (last - first) / static_cast<double>(values.size() - 1) : 0.0; }
};

/// The longest over trials and channels, s.
double residual_correlation_time(const ShootingProblem& problem, const std::vector<ReducedRows>& rows) {
  std::map<std::pair<std::size_t, std::size_t>, Trace> traces;
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (Eigen::Index row = 0; row < problem.robust_rows(k); ++row) {
      const ResidualPlace place = problem.place(k, row);
      Trace& trace = traces[{place.trial, place.channel}];
      if (trace.values.empty()) trace.first = place.time;
      trace.last = place.time;
      trace.values.push_back(rows[k].score(row));
    }
  double longest = 0.0;
  for (const auto& [where, trace] : traces)
    longest = std::max(longest, trace.interval() * correlation_samples(trace.values));
  return longest;
}

/// The blocks that scores are summed over: several correlation times long, but enough of them.
TimeBlocks choose_blocks(const ShootingProblem& problem, Eigen::Index values, Uncertainty& result) {
  const double least = std::max(kLeastBlocks, 3 * static_cast<int>(values));
  const double wanted = kBlockCorrelations * result.correlation_time;
  const double longest = scored_duration(problem) / least;
  result.few_blocks = wanted > longest;
  TimeBlocks blocks(problem, std::min(wanted, longest));
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

/// Mean square of the scores × samples in a correlation time: what a sum over time really varies by.
double correlated_variance(const ShootingProblem& problem, const std::vector<ReducedRows>& rows,
                           double correlation_time) {
  const auto count = static_cast<double>(problem.samples());
  const double duration = scored_duration(problem);
  const double remembered = duration > 0.0 ? std::max(1.0, correlation_time * count / duration) : 1.0;
  return total_power(rows) / count * remembered;
}

/// What a relative change of 1 means: the value itself, or where it is small, the change that shows as much
/// as the residual does.
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

/// The inverse of the information in relative changes, without the directions that the data do not determine;
/// these go to `result`.
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
  result.correlation_time = residual_correlation_time(problem, rows);
  result.sizes = typical_sizes(space, point, all, total_power(rows));
  result.determined.assign(at_bound.size(), true);
  result.covariance = Eigen::MatrixXd::Constant(space.size(), space.size(), kNothing);
  const TimeBlocks blocks = choose_blocks(problem, space.size(), result);

  std::vector<Eigen::Index> free;
  for (Eigen::Index j = 0; j < space.size(); ++j)
    if (!at_bound[static_cast<std::size_t>(j)]) free.push_back(j);
  if (free.empty()) return result;
  const Eigen::VectorXd scale = result.sizes(free);
  const Eigen::MatrixXd relative = scale.asDiagonal() * all(free, free) * scale.asDiagonal();
  const double variance = correlated_variance(problem, rows, result.correlation_time);
  const Eigen::MatrixXd bread =
      scale.asDiagonal() * determined_inverse(relative, variance, free, result) * scale.asDiagonal();

  const int degrees = std::max(1, result.blocks - static_cast<int>(free.size()));
  result.quantile = boost::math::quantile(boost::math::students_t(degrees), 0.975);
  const Eigen::MatrixXd scores = block_scores(rows, blocks)(free, Eigen::all);
  result.covariance(free, free) =
      bread * (scores * scores.transpose()) * bread * (static_cast<double>(result.blocks) / degrees);
  for (const Eigen::Index j : free) {
    if (result.determined[static_cast<std::size_t>(j)]) continue;
    result.covariance.row(j).setConstant(kNothing);
    result.covariance.col(j).setConstant(kNothing);
  }
  return result;
}

}  // namespace lacuna
