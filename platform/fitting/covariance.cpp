#include "fitting/covariance.h"

#include "fitting/correlation_time.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace lacuna {
namespace {

constexpr double kBlockCorrelations = 6.0;  ///< a block is so many correlation times long
constexpr double kRounding = 1e-10;         ///< eigenvalues below this share of the largest are differences' rounding

/// What the shared values alone explain: rows with the start state's share projected off.
struct ReducedRows {
  Eigen::MatrixXd sensitivity;  ///< rows × values
  Eigen::VectorXd curvature;    ///< the loss's, per row
  Eigen::VectorXd score;        ///< weight × residual
};

ReducedRows reduce(const ShootingProblem& problem, std::size_t k, const Eigen::VectorXd& residuals,
                   const SegmentJacobian& jacobian, const RobustLoss& loss) {
  ReducedRows rows;
  rows.curvature = Eigen::VectorXd::Ones(residuals.size());
  rows.score = residuals;
  for (Eigen::Index row = 0; row < problem.robust_rows(k); ++row) {
    rows.curvature(row) = loss.curvature(residuals(row));
    rows.score(row) = loss.weight(residuals(row)) * residuals(row);
  }
  rows.sensitivity = jacobian.values;
  if (jacobian.state.cols() == 0) return rows;
  const Eigen::MatrixXd weighted = rows.curvature.asDiagonal() * jacobian.state;
  const Eigen::MatrixXd information = weighted.transpose() * jacobian.state;
  rows.sensitivity -= jacobian.state * information.ldlt().solve(weighted.transpose() * jacobian.values);
  return rows;
}

/// Residuals of one trial and channel in the order of time, with the time between two of them.
struct Trace {
  std::vector<double> values;
  double first = 0.0, last = 0.0;
  double interval() const { return values.size() > 1 ? (last - first) / static_cast<double>(values.size() - 1) : 0.0; }
};

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

/// Splits every trial's scored time into equal blocks of about `length` s.
class Blocks {
 public:
  Blocks(const ShootingProblem& problem, double length) : length_(length) {
    for (std::size_t k = 0; k < problem.segments().size(); ++k) {
      const Eigen::Index rows = problem.robust_rows(k);
      if (rows == 0) continue;
      const ResidualPlace from = problem.place(k, 0);
      Span& span = spans_.try_emplace(from.trial, Span{from.time, from.time, 0, 0}).first->second;
      span.begin = std::min(span.begin, from.time);
      span.end = std::max(span.end, problem.place(k, rows - 1).time);
    }
    for (auto& [trial, span] : spans_) {
      span.first = count_;
      span.blocks = std::max(1, static_cast<int>((span.end - span.begin) / std::max(length_, 1e-12)));
      count_ += span.blocks;
    }
  }
  int count() const { return count_; }
  double duration() const {
    double sum = 0.0;
    for (const auto& [trial, span] : spans_) sum += span.end - span.begin;
    return sum;
  }
  int of(const ResidualPlace& place) const {
    const Span& span = spans_.at(place.trial);
    const double share = span.end > span.begin ? (place.time - span.begin) / (span.end - span.begin) : 0.0;
    return span.first + std::min(span.blocks - 1, static_cast<int>(share * span.blocks));
  }

 private:
  struct Span {
    double begin, end;
    int first, blocks;
  };
  double length_;
  std::map<std::size_t, Span> spans_;
  int count_ = 0;
};

Eigen::MatrixXd block_scores(const ShootingProblem& problem, const std::vector<ReducedRows>& rows,
                             const Blocks& blocks) {
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(rows.front().sensitivity.cols(), blocks.count());
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (Eigen::Index row = 0; row < rows[k].score.size(); ++row) {
      // A prior belongs to the moment its state stands for.
      const Eigen::Index where = row < problem.robust_rows(k) ? row : 0;
      sums.col(blocks.of(problem.place(k, where))) += rows[k].sensitivity.row(row).transpose() * rows[k].score(row);
    }
  return sums;
}

/// Mean square of the scores × correlation: what a sum over time really varies by.
double inflation(const ShootingProblem& problem, const std::vector<ReducedRows>& rows, double correlation_time,
                 double duration) {
  double power = 0.0, count = 0.0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    power += rows[k].score.head(problem.robust_rows(k)).squaredNorm();
    count += static_cast<double>(problem.robust_rows(k));
  }
  const double remembered = duration > 0.0 ? std::max(1.0, correlation_time * count / duration) : 1.0;
  return count > 0.0 ? power / count * remembered : 1.0;
}

/// What a relative change of 1 means: the value itself, or where it is small, the change that shows as much
/// as the residual does.
double size_of(const ParameterSpace& space, const FitPoint& point, Eigen::Index j, double information, double power) {
  if (space.logarithmic(j)) return 1.0;
  const double shows = information > 0.0 ? std::sqrt(power / information) : 0.0;
  const double size = std::max(std::abs(point.values(j)), shows);
  return size > 0.0 ? size : space.upper()(j) - space.lower()(j);
}

}  // namespace

Uncertainty uncertainty(const ShootingProblem& problem, const ParameterSpace& space, const FitPoint& point,
                        const std::vector<Eigen::VectorXd>& residuals, const std::vector<SegmentJacobian>& jacobians,
                        const RobustLoss& loss, const std::vector<bool>& at_bound) {
  const Eigen::Index size = space.size();
  Uncertainty result;
  std::vector<ReducedRows> rows;
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(size, size);
  double power = 0.0;
  for (std::size_t k = 0; k < residuals.size(); ++k) {
    rows.push_back(reduce(problem, k, residuals[k], jacobians[k], loss));
    information += rows[k].sensitivity.transpose() * rows[k].curvature.asDiagonal() * rows[k].sensitivity;
    power += rows[k].score.squaredNorm();
  }
  result.correlation_time = residual_correlation_time(problem, rows);
  const double duration = Blocks(problem, 1.0).duration();
  const int least_blocks = std::max<int>(12, 3 * static_cast<int>(size));
  const double block = std::min(kBlockCorrelations * result.correlation_time, duration / least_blocks);
  result.few_blocks = block < kBlockCorrelations * result.correlation_time;
  const Blocks blocks(problem, block);
  result.blocks = blocks.count();

  std::vector<Eigen::Index> free;
  Eigen::VectorXd sizes(size);
  for (Eigen::Index j = 0; j < size; ++j) {
    sizes(j) = size_of(space, point, j, information(j, j), power);
    if (!at_bound[static_cast<std::size_t>(j)]) free.push_back(j);
  }
  result.sizes.assign(sizes.data(), sizes.data() + size);
  result.determined.assign(static_cast<std::size_t>(size), true);
  result.covariance = Eigen::MatrixXd::Constant(size, size, std::numeric_limits<double>::quiet_NaN());
  if (free.empty()) return result;

  const auto count = static_cast<Eigen::Index>(free.size());
  const Eigen::VectorXd scale = sizes(free);
  const Eigen::MatrixXd relative = scale.asDiagonal() * information(free, free) * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(relative);
  const double varies = inflation(problem, rows, result.correlation_time, duration);
  const double rounding = kRounding * eigen.eigenvalues()(count - 1);
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double value = eigen.eigenvalues()(i);
    const Eigen::VectorXd direction = eigen.eigenvectors().col(i);
    if (value > rounding && std::sqrt(varies / value) < kUndetermined) {
      inverse += direction * direction.transpose() / value;
      continue;
    }
    Eigen::VectorXd full = Eigen::VectorXd::Zero(size);
    full(free) = direction;
    result.undetermined.push_back(full);
    for (Eigen::Index j = 0; j < size; ++j)
      if (std::abs(full(j)) > 0.1 * full.cwiseAbs().maxCoeff()) result.determined[static_cast<std::size_t>(j)] = false;
  }

  const int degrees = std::max(1, result.blocks - static_cast<int>(count));
  result.quantile = boost::math::quantile(boost::math::students_t(degrees), 0.975);
  const Eigen::MatrixXd scores = block_scores(problem, rows, blocks)(free, Eigen::all);
  const Eigen::MatrixXd bread = scale.asDiagonal() * inverse * scale.asDiagonal();
  const Eigen::MatrixXd covariance =
      bread * (scores * scores.transpose()) * bread * (static_cast<double>(result.blocks) / degrees);
  for (Eigen::Index a = 0; a < count; ++a)
    for (Eigen::Index b = 0; b < count; ++b)
      if (result.determined[static_cast<std::size_t>(free[static_cast<std::size_t>(a)])] &&
          result.determined[static_cast<std::size_t>(free[static_cast<std::size_t>(b)])])
        result.covariance(free[static_cast<std::size_t>(a)], free[static_cast<std::size_t>(b)]) = covariance(a, b);
  return result;
}

}  // namespace lacuna
