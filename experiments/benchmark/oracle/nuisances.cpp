#include "oracle/nuisances.h"

#include "refit/difference_steps.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace hidden_effects {
namespace {

using Index = Eigen::Index;
using ByTrial = std::vector<Eigen::VectorXd>;

constexpr double kDependent = 1e-8;

Eigen::VectorXd residual(const Question& at, std::size_t t, const Eigen::VectorXd& values, const Start& start) {
  const Readings& measured = at.trials[t].readings;
  const Readings predicted = predict(at.model, values, at.trials[t].excitation, start, at.step);
  Eigen::MatrixXd table(static_cast<Index>(measured.front().size()), static_cast<Index>(measured.size()));
  for (std::size_t s = 0; s < measured.size(); ++s)
    for (std::size_t k = 0; k < measured[s].size(); ++k)
      table(static_cast<Index>(k), static_cast<Index>(s)) = measured[s][k] - predicted[s][k];
  return at.whiten(t, table);
}

Eigen::MatrixXd of_start(const Question& at, std::size_t t, const Eigen::VectorXd& base) {
  const Index joints = at.starts[t].position.size();
  Eigen::MatrixXd columns(base.size(), 2 * joints);
  for (Index i = 0; i < 2 * joints; ++i) {
    Start moved = at.starts[t];
    (i < joints ? moved.position[i] : moved.velocity[i - joints]) += kStartStep;
    columns.col(i) = (base - residual(at, t, at.values, moved)) / kStartStep;
  }
  return columns;
}

Eigen::MatrixXd of_values(const Question& at, std::size_t t, const Eigen::VectorXd& base) {
  Eigen::MatrixXd columns(base.size(), at.values.size());
  for (Index i = 0; i < at.values.size(); ++i) {
    Eigen::VectorXd moved = at.values;
    const double step = std::max(kRelativeStep * std::abs(moved[i]), kLeastStep);
    moved[i] += step;
    columns.col(i) = (base - residual(at, t, moved, at.starts[t])) / step;
  }
  return columns;
}

Eigen::MatrixXd below(const std::vector<Eigen::MatrixXd>& parts) {
  Index rows = 0;
  for (const Eigen::MatrixXd& part : parts) rows += part.rows();
  Eigen::MatrixXd all(rows, parts.front().cols());
  Index row = 0;
  for (const Eigen::MatrixXd& part : parts) {
    all.middleRows(row, part.rows()) = part;
    row += part.rows();
  }
  return all;
}

}  // namespace

Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns) {
  Eigen::MatrixXd scaled = columns;
  for (Index i = 0; i < scaled.cols(); ++i) scaled.col(i) /= std::max(scaled.col(i).norm(), 1e-300);
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factor(scaled);
  factor.setThreshold(kDependent);
  return factor.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), factor.rank());
}

ByTrial whitened_residuals(const Question& at) {
  ByTrial all;
  for (std::size_t t = 0; t < at.trials.size(); ++t) all.push_back(residual(at, t, at.values, at.starts[t]));
  return all;
}

Nuisances::Nuisances(const Question& at) {
  std::vector<Eigen::MatrixXd> values;
  for (std::size_t t = 0; t < at.trials.size(); ++t) {
    const Eigen::VectorXd base = residual(at, t, at.values, at.starts[t]);
    start_basis_.push_back(orthonormal(of_start(at, t, base)));
    Eigen::MatrixXd columns = of_values(at, t, base);
    columns -= start_basis_.back() * (start_basis_.back().transpose() * columns).eval();
    values.push_back(std::move(columns));
  }
  of_values_ = below(values);
  value_basis_ = orthonormal(of_values_);
}

Nuisances Nuisances::without(Index first, Index count) const {
  Nuisances fewer = *this;
  fewer.of_values_.resize(of_values_.rows(), of_values_.cols() - count);
  fewer.of_values_ << of_values_.leftCols(first), of_values_.rightCols(of_values_.cols() - first - count);
  fewer.value_basis_ = orthonormal(fewer.of_values_);
  return fewer;
}

Eigen::VectorXd Nuisances::projected(const ByTrial& by_trial) const {
  std::vector<Eigen::MatrixXd> parts;
  for (std::size_t t = 0; t < by_trial.size(); ++t)
    parts.push_back(by_trial[t] - start_basis_[t] * (start_basis_[t].transpose() * by_trial[t]).eval());
  Eigen::VectorXd all = below(parts);
  all -= value_basis_ * (value_basis_.transpose() * all).eval();
  return all;
}

}  // namespace hidden_effects
