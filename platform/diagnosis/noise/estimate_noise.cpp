#include "diagnosis/noise/noise_model.h"
#include "foundation/interrupt.h"
#include "foundation/parallel.h"

#include <nlopt.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kRange = 1e3;        // deviations from 1/kRange to kRange times their sizes
constexpr double kUnlikely = 1e300;   // where a covariance is not positive definite
constexpr double kNegligible = 1e-6;  // of the largest direction's power
constexpr double kMostShare = 0.2;    // of the rows, that may be projected out
constexpr Eigen::Index kMostDirections = 60;
constexpr int kMostEvaluations = 100;
constexpr std::array kStarts = {-2.0, 0.0, -1.0};  // logarithms of sizes, of all but white sensor noise

/// An orthonormal-like basis of what the values and the columns span, by segment: the strongest directions.
std::vector<Eigen::MatrixXd> explained(const std::vector<LinearSegment>& segments,
                                       const std::vector<Eigen::MatrixXd>& columns) {
  std::vector<Eigen::MatrixXd> all;
  Eigen::Index rows = 0;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    Eigen::MatrixXd both(segments[k].residual.size(), segments[k].values.cols() + columns[k].cols());
    both << segments[k].values, columns[k];
    rows += both.rows();
    all.push_back(std::move(both));
  }
  const Eigen::Index count = all.front().cols();
  Eigen::VectorXd power = Eigen::VectorXd::Zero(count);
  for (const Eigen::MatrixXd& one : all) power += one.colwise().squaredNorm().transpose();
  const Eigen::VectorXd unit = power.unaryExpr([](double p) { return p > 0.0 ? 1.0 / std::sqrt(p) : 0.0; });
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::MatrixXd& one : all) {
    one *= unit.asDiagonal();
    dense::add_square(1.0, one.transpose(), gram);
  }
  const dense::Eigenvectors eigen(std::move(gram));
  const double least = kNegligible * std::max(eigen.values(count - 1), 0.0);
  const Eigen::Index most =
      std::min(kMostDirections, static_cast<Eigen::Index>(kMostShare * static_cast<double>(rows)));
  Eigen::Index kept = 0;
  while (kept < std::min(most, count) && eigen.values(count - 1 - kept) > least) ++kept;
  const Eigen::MatrixXd basis =
      eigen.vectors.rightCols(kept) * eigen.values.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
  for (Eigen::MatrixXd& one : all) one = dense::product(one, basis);
  return all;
}

class MarginalLikelihood {
 public:
  MarginalLikelihood(NoiseModel& noise, const std::vector<LinearSegment>& segments,
                     std::vector<Eigen::MatrixXd> explained, int threads)
      : noise_(noise),
        segments_(segments),
        explained_(std::move(explained)),
        parts_(segments.size()),
        threads_(threads) {
    for (const LinearSegment& segment : segments_) power_ += segment.residual.squaredNorm();
    power_ = std::max(power_, 1e-300);
  }

  /// −2 log of the likelihood at these deviations, but for a constant; `slopes`, if not empty, gets its derivatives by
  /// the logarithms of the deviations.
  double operator()(const std::vector<double>& deviations, std::vector<double>& slopes) {
    throw_if_interrupted();
    noise_.set_deviations(deviations);
    parallel_for(segments_.size(), threads_, [&](std::size_t k, int) { whiten(k); });
    if (!std::all_of(parts_.begin(), parts_.end(), [](const Part& one) { return one.factor.exists(); }))
      return unlikely(slopes);
    const Eigen::Index count = explained_.front().cols();
    Explained explained{0.0, Eigen::MatrixXd::Identity(count, count) / power_, Eigen::VectorXd::Zero(count)};
    for (const Part& one : parts_) {
      explained.deviance += one.deviance;
      dense::add_square(1.0, one.columns.transpose(), explained.information);
      explained.score += one.columns.transpose() * one.residual;
    }
    const dense::Cholesky solver(std::move(explained.information));
    if (!solver.exists()) return unlikely(slopes);
    Eigen::VectorXd sizes = explained.score;
    solver.solve_lower(sizes);
    solver.solve_upper(sizes);
    if (!slopes.empty()) add_slopes(solver, sizes, slopes);
    return explained.deviance + solver.log_determinant() - explained.score.dot(sizes);
  }

 private:
  /// A segment, whitened.
  struct Part {
    double deviance = 0.0;
    dense::Cholesky factor;   ///< of noise and start together
    Eigen::MatrixXd storage;  ///< where there is no factor
    Eigen::VectorXd residual;
    Eigen::MatrixXd columns;
  };

  struct Explained {
    double deviance = 0.0;
    Eigen::MatrixXd information;  ///< the lower half
    Eigen::VectorXd score;
  };

  static double unlikely(std::vector<double>& slopes) {
    std::fill(slopes.begin(), slopes.end(), 0.0);
    return kUnlikely;
  }

  void whiten(std::size_t k) {
    const LinearSegment& segment = segments_[k];
    Part& part = parts_[k];
    const auto covariance = [&](Eigen::MatrixXd& sum) {
      noise_.lower_covariance(k, sum);
      dense::add_square(1.0, segment.state, sum);
    };
    part.factor = factor_of(covariance, part.factor.exists() ? part.factor.take() : std::move(part.storage));
    if (!part.factor.exists()) return;
    part.residual = segment.residual;
    part.factor.solve_lower(part.residual);
    part.columns = explained_[k];
    part.factor.solve_lower(part.columns);
    part.deviance = part.factor.log_determinant() + part.residual.squaredNorm();
  }

  /// Uses up the factors of the segments. dD = Σ tr[(P − P r rᵀ P) dV], P = V⁻¹ − V⁻¹ X (Xᵀ V⁻¹ X)⁻¹ Xᵀ V⁻¹ (Harville
  /// 1977).
  void add_slopes(const dense::Cholesky& solver, const Eigen::VectorXd& sizes, std::vector<double>& slopes) {
    std::vector<Eigen::VectorXd> by_segment(parts_.size());
    parallel_for(parts_.size(), threads_, [&](std::size_t k, int) {
      Part& one = parts_[k];
      Eigen::MatrixXd taken(one.columns.rows(), one.columns.cols() + 1);
      taken.rightCols(1) = one.residual;
      dense::add_product(-1.0, one.columns, sizes, taken.rightCols(1));
      taken.leftCols(one.columns.cols()) = one.columns;
      solver.solve_from_right(taken.leftCols(one.columns.cols()));
      one.factor.solve_upper(taken);
      Eigen::MatrixXd& weights = one.storage = one.factor.take();
      dense::invert_square(weights);
      dense::add_square(-1.0, taken, weights);
      by_segment[k] = noise_.slopes(k, weights);
    });
    std::fill(slopes.begin(), slopes.end(), 0.0);
    for (const Eigen::VectorXd& of : by_segment)
      for (std::size_t i = 0; i < slopes.size(); ++i) slopes[i] += of(static_cast<Eigen::Index>(i));
  }

  NoiseModel& noise_;
  const std::vector<LinearSegment>& segments_;
  std::vector<Eigen::MatrixXd> explained_;
  std::vector<Part> parts_;  ///< kept from one evaluation to the next for their memory
  int threads_;
  double power_ = 0.0;  ///< of the residuals: variance of what is explained, a priori, by direction
};

struct NoiseSearch {
  MarginalLikelihood likelihood;
  const std::vector<double>& sizes;

  /// `logarithms`: of multiples of sizes.
  std::vector<double> deviations(const std::vector<double>& logarithms) const {
    std::vector<double> all;
    for (std::size_t i = 0; i < sizes.size(); ++i) all.push_back(sizes[i] * std::exp(logarithms[i]));
    return all;
  }
};

double minus_two_log_likelihood(const std::vector<double>& logarithms, std::vector<double>& slopes, void* data) {
  NoiseSearch& search = *static_cast<NoiseSearch*>(data);
  return search.likelihood(search.deviations(logarithms), slopes);
}

std::vector<double> lower_bounds(const NoiseModel& noise) {
  std::vector<double> lower;
  for (std::size_t i = 0; i < noise.sizes().size(); ++i)
    lower.push_back(std::log(std::clamp(noise.least()[i] / std::max(noise.sizes()[i], 1e-300), 1.0 / kRange, kRange)));
  return lower;
}

std::vector<double> start_of(const NoiseModel& noise, double start, const std::vector<double>& lower) {
  std::vector<double> logarithms;
  for (const NoiseComponent& one : noise.components())
    logarithms.push_back(one.kind == NoiseComponent::Kind::sensor ? 0.0 : start);
  for (std::size_t i = 0; i < lower.size(); ++i) logarithms[i] = std::max(logarithms[i], lower[i]);
  return logarithms;
}

}  // namespace

void estimate_noise(NoiseModel& noise, const std::vector<LinearSegment>& segments,
                    const std::vector<Eigen::MatrixXd>& columns, int threads) {
  NoiseSearch data{{noise, segments, explained(segments, columns), threads}, noise.sizes()};
  const std::vector<double> lower = lower_bounds(noise);
  nlopt::opt search(nlopt::LD_LBFGS, static_cast<unsigned>(lower.size()));
  search.set_min_objective(minus_two_log_likelihood, &data);
  search.set_lower_bounds(lower);
  search.set_upper_bounds(std::log(kRange));
  search.set_ftol_abs(0.01);
  search.set_maxeval(kMostEvaluations);
  std::vector<double> best;
  double least = kUnlikely;
  for (const double start : kStarts) {
    std::vector<double> found = start_of(noise, start, lower);
    double value = kUnlikely;
    try {
      search.optimize(found, value);
    } catch (
        const std::exception&) {  // the library hides what the objective threw; rounding ends a search that is done
      throw_if_interrupted();
    }
    if (!(value < least) && !best.empty()) continue;
    least = value;
    best = found;
  }
  noise.set_deviations(data.deviations(best));
}

}  // namespace lacuna
