#include "where_it_fails/residual_tests.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace lacuna {
namespace {

constexpr double kTestLevel = 0.01;
constexpr int kFewestWeights = 6, kMostWeights = 32;
constexpr std::size_t kMeans = 10;
constexpr Eigen::Index kFewestRows = 30;
constexpr double kNew = 0.01;  // of a feature's variance: the least that remains beside the covariates and their noise

std::vector<Eigen::Index> ascending(const Eigen::VectorXd& values) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(values.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) { return values(a) < values(b); });
  return order;
}

/// 1 + 2 Σ ρ² in samples: the longest memory of products with this residual. In growing steps of the lag.
double memory_of(const Eigen::VectorXd& residual) {
  const double power = residual.squaredNorm();
  if (!(power > 0.0)) return 1.0;
  double sum = 1.0;
  Eigen::Index before = 0;
  const Eigen::Index last = residual.size() / 4;
  for (Eigen::Index lag = 1; lag < last; lag += std::max<Eigen::Index>(1, lag / 8)) {
    const double correlation = residual.head(residual.size() - lag).dot(residual.tail(residual.size() - lag)) / power;
    sum += 2.0 * static_cast<double>(lag - before) * correlation * correlation;
    before = lag;
  }
  return sum;
}

/// The number of cosine weights: all of them lie in the flat low-frequency part of the spectrum.
int weights_for(double memory, Eigen::Index rows) {
  constexpr double kReach = 6.0;  // correlation times in half a period of the fastest weight
  return std::clamp(static_cast<int>(static_cast<double>(rows) / (kReach * memory)), kFewestWeights, kMostWeights);
}

/// A square root of a covariance: times independent numbers of variance 1 it gives numbers of this covariance.
Eigen::MatrixXd root_of(const Eigen::MatrixXd& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(covariance);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

/// An orthonormal basis of what the columns span.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
  qr.setThreshold(1e-9);
  return qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), qr.rank());
}

}  // namespace

Eigen::MatrixXd feature_basis(const Eigen::VectorXd& feature, bool classes) {
  const Eigen::VectorXd centred = feature.array() - feature.mean();
  const double size = std::sqrt(centred.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(1, centred.size())));
  if (!(size > 1e-12 * feature.cwiseAbs().maxCoeff())) return Eigen::MatrixXd(feature.size(), 0);
  Eigen::MatrixXd basis(feature.size(), 2);
  basis.col(0) = centred / size;
  basis.col(1) = basis.col(0).array().square();
  basis.col(1).array() -= basis.col(1).mean();
  basis.col(1) -= basis.col(0).dot(basis.col(1)) / basis.col(0).squaredNorm() * basis.col(0);
  // For a feature with two values the square adds nothing.
  const bool both = !classes && basis.col(1).squaredNorm() > 1e-9 * basis.col(0).squaredNorm();
  return basis.leftCols(both ? 2 : 1);
}

ResidualTester::ResidualTester(const Eigen::VectorXd& residual, const Eigen::MatrixXd& covariates, std::size_t family)
    : all_rows_(residual.size()), family_(std::max<std::size_t>(family, 1)) {
  for (Eigen::Index row = 0; row < residual.size(); ++row)
    if (std::isfinite(residual(row)) && (covariates.cols() == 0 || covariates.row(row).allFinite()))
      rows_.push_back(row);
  raw_ = residual(rows_);
  squares_ = raw_.squaredNorm();
  const Eigen::Index n = raw_.size();
  if (n < kFewestRows) return;
  Eigen::MatrixXd taken(n, covariates.cols() + 1);
  taken.col(0).setOnes();
  if (covariates.cols() > 0) taken.rightCols(covariates.cols()) = covariates(rows_, Eigen::all);
  for (auto column : taken.colwise())
    if (column.norm() > 0.0) column.normalize();
  taken_ = orthonormal(taken);
  residual_ = without_covariates(raw_);
  cosines_.resize(n, kMostWeights);
  for (int j = 0; j < kMostWeights; ++j)
    for (Eigen::Index t = 0; t < n; ++t)
      cosines_(t, j) = std::sqrt(2.0) *
                       std::cos(std::numbers::pi * (j + 1) * (static_cast<double>(t) + 0.5) / static_cast<double>(n));
}

Eigen::MatrixXd ResidualTester::without_covariates(const Eigen::MatrixXd& columns) const {
  return columns - taken_ * (taken_.transpose() * columns);
}

IndependenceTest ResidualTester::of(const Eigen::VectorXd& feature) const { return test(feature, false); }

IndependenceTest ResidualTester::of_classes(const Eigen::VectorXd& feature) const { return test(feature, true); }

IndependenceTest ResidualTester::of_mean() const {
  IndependenceTest result;
  if (raw_.size() < kFewestRows || !(squares_ > 0.0)) return result;
  const double mean = raw_.mean();
  const Eigen::VectorXd rest = raw_.array() - mean;
  result.share = mean * mean * static_cast<double>(raw_.size()) / squares_;
  judge(rest, Eigen::VectorXd::Ones(1), Eigen::VectorXd::Constant(1, raw_.sum()), memory_of(rest), result);
  return result;
}

IndependenceTest ResidualTester::test(const Eigen::VectorXd& feature, bool classes) const {
  IndependenceTest result;
  if (raw_.size() < kFewestRows || !(squares_ > 0.0)) return result;
  const Eigen::VectorXd values = feature(rows_);
  const Eigen::MatrixXd columns = feature_basis(values, classes);
  if (columns.cols() == 0) return result;
  const Eigen::MatrixXd left = without_covariates(columns);
  if (left.squaredNorm() < kNew * columns.squaredNorm()) return result;  // the covariates already contain the feature
  const Eigen::MatrixXd basis = orthonormal(left);
  const Eigen::VectorXd sums = basis.transpose() * residual_;
  const Eigen::VectorXd rest = residual_ - basis * sums;
  result.share = std::min(1.0, sums.squaredNorm() / squares_);
  const Eigen::MatrixXd scores = basis.array().colwise() * rest.array();
  double memory = 1.0;
  for (Eigen::Index k = 0; k < scores.cols(); ++k) memory = std::max(memory, memory_of(scores.col(k)));
  const Eigen::MatrixXd covariance =
      judge(scores, share_kept(basis, weights_for(memory, basis.rows())), sums, memory, result);

  const bool alone = taken_.cols() == 1;
  const Eigen::MatrixXd whole =
      columns * left.colPivHouseholderQr().solve(basis);  // the component in the span of the basis
  const Eigen::VectorXd shown = alone ? raw_ : Eigen::VectorXd(rest + whole * sums);
  result.shown.setConstant(all_rows_, std::numeric_limits<double>::quiet_NaN());
  result.shown(rows_) = shown;
  const Eigen::MatrixXd parts = alone ? Eigen::MatrixXd(shown.size(), 0) : Eigen::MatrixXd(whole * root_of(covariance));
  result.bins = bins(values, shown, parts, classes ? static_cast<std::size_t>(values.size()) : kMeans);
  return result;
}

Eigen::VectorXd ResidualTester::share_kept(const Eigen::MatrixXd& basis, int weights) const {
  Eigen::VectorXd kept(basis.cols());
  for (Eigen::Index k = 0; k < basis.cols(); ++k) {
    const Eigen::MatrixXd weighted = cosines_.leftCols(weights).array().colwise() * basis.col(k).array();
    const double lost = (taken_.transpose() * weighted).squaredNorm() + (basis.transpose() * weighted).squaredNorm();
    kept(k) = 1.0 - lost / weighted.squaredNorm();
  }
  return kept.cwiseMax(0.1);
}

Eigen::MatrixXd ResidualTester::judge(const Eigen::MatrixXd& scores, const Eigen::VectorXd& kept,
                                      const Eigen::VectorXd& sums, double memory, IndependenceTest& result) const {
  const int weights = weights_for(memory, scores.rows());
  const auto q = static_cast<int>(scores.cols());
  const Eigen::MatrixXd series = cosines_.leftCols(weights).transpose() * scores;
  const Eigen::VectorXd scale = kept.cwiseSqrt().cwiseInverse();
  Eigen::MatrixXd covariance = scale.asDiagonal() * (series.transpose() * series / weights) * scale.asDiagonal();
  result.numerator = q;
  result.denominator = weights - q + 1;
  result.testable = true;
  const double wald = sums.dot(covariance.ldlt().solve(sums));
  const boost::math::fisher_f chance(result.numerator, result.denominator);
  result.critical = boost::math::quantile(boost::math::complement(chance, kTestLevel / static_cast<double>(family_)));
  if (!(covariance.trace() > 0.0) || !std::isfinite(wald)) {  // the residual vanishes: the feature explains all of it
    result.statistic = std::numeric_limits<double>::infinity();
    result.p = 0.0;
    return covariance;
  }
  result.statistic = wald * result.denominator / (static_cast<double>(weights) * q);
  result.p = boost::math::cdf(boost::math::complement(chance, std::max(0.0, result.statistic)));
  return covariance;
}

std::vector<ResidualBin> ResidualTester::bins(const Eigen::VectorXd& feature, const Eigen::VectorXd& shown,
                                              const Eigen::MatrixXd& parts, std::size_t most) const {
  const std::vector<Eigen::Index> order = ascending(feature);
  const std::size_t size = std::max<std::size_t>(1, order.size() / most);
  const int weights = weights_for(memory_of(shown.array() - shown.mean()), shown.size());
  const double t = boost::math::quantile(boost::math::complement(boost::math::students_t(weights), 0.5 * kTestLevel));
  std::vector<ResidualBin> all;
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = std::min(begin + size, order.size());
    while (end < order.size() && feature(order[end]) == feature(order[end - 1])) ++end;
    if (order.size() - end < size / 2) end = order.size();
    ResidualBin bin{.lower = feature(order[begin]), .upper = feature(order[end - 1]), .samples = end - begin};
    const auto n = static_cast<double>(bin.samples);
    for (std::size_t i = begin; i < end; ++i) {
      bin.feature += feature(order[i]) / n;
      bin.mean += shown(order[i]) / n;
    }
    Eigen::VectorXd series = Eigen::VectorXd::Zero(weights), part = Eigen::VectorXd::Zero(parts.cols());
    for (std::size_t i = begin; i < end; ++i) {
      series += (shown(order[i]) - bin.mean) * cosines_.row(order[i]).head(weights).transpose();
      part += parts.row(order[i]).transpose();
    }
    bin.band = t * std::sqrt(series.squaredNorm() / weights + part.squaredNorm()) / n;
    all.push_back(bin);
    begin = end;
  }
  return all;
}

}  // namespace lacuna
