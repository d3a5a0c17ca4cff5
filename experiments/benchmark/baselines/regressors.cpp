#include "baselines/regressors.h"

#include "baselines/acceleration_balance.h"
#include "baselines/zero_phase.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace hidden_effects {
namespace {

constexpr double kEnds = 0.1;  ///< s, left out where a trial begins and ends
constexpr int kIterations = 5;
constexpr double kShareOfValue = 1e-3, kLeastStep = 1e-6;

double step_of(double value) { return std::max(kShareOfValue * std::abs(value), kLeastStep); }

}  // namespace

std::size_t Regression::thinning(std::size_t trial) const {
  const double interval = seen_.trials[trial].excitation.interval;
  return std::max<std::size_t>(1, static_cast<std::size_t>(0.5 / (motions_.cutoff * interval)));
}

std::vector<std::size_t> Regression::kept(std::size_t trial) const {
  const Excitation& excitation = seen_.trials[trial].excitation;
  const auto end = static_cast<std::size_t>(kEnds / excitation.interval);
  std::vector<std::size_t> samples;
  for (std::size_t k = end; k + end < excitation.samples(); k += thinning(trial)) samples.push_back(k);
  return samples;
}

Eigen::VectorXd Regression::column(const PlantModel& model, const Eigen::VectorXd& values) const {
  std::vector<double> all;
  for (std::size_t t = 0; t < seen_.trials.size(); ++t) {
    const Excitation& excitation = seen_.trials[t].excitation;
    const Eigen::MatrixXd balance = acceleration_balance(model, values, excitation, motions_.trials[t]);
    if (balance.size() == 0 || !balance.allFinite()) return {};
    for (Eigen::Index j = 0; j < balance.cols(); ++j) {
      const std::vector<double> raw(balance.col(j).data(), balance.col(j).data() + balance.rows());
      const std::vector<double> smooth = zero_phase(raw, excitation.interval, motions_.cutoff);
      for (const std::size_t k : kept(t)) all.push_back(smooth[k]);
    }
  }
  return Eigen::Map<Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

std::vector<std::size_t> Regression::joint_of_row() const {
  std::vector<std::size_t> joints;
  for (std::size_t t = 0; t < seen_.trials.size(); ++t)
    for (std::size_t j = 0; j < seen_.base.spec.joints.size(); ++j) joints.insert(joints.end(), kept(t).size(), j);
  return joints;
}

Eigen::VectorXd Regression::fitted_base() const {
  Eigen::VectorXd values = seen_.nominal(), balance = column(seen_.base, values);
  for (int i = 0; i < kIterations; ++i) {
    Eigen::VectorXd step = of_base(values).colPivHouseholderQr().solve(balance);
    for (int half = 0; half < kIterations; ++half, step *= 0.5) {
      const Eigen::VectorXd left = column(seen_.base, values - step);
      if (left.size() != balance.size() || !(left.squaredNorm() < balance.squaredNorm())) continue;
      values -= step;
      balance = left;
      break;
    }
  }
  return values;
}

Eigen::MatrixXd Regression::of_base(const Eigen::VectorXd& values) const {
  const Eigen::VectorXd middle = column(seen_.base, values);
  Eigen::MatrixXd columns(middle.size(), values.size());
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    Eigen::VectorXd moved = values;
    const double step = step_of(moved[i]);
    moved[i] += step;
    columns.col(i) = (column(seen_.base, moved) - middle) / step;
  }
  return columns;
}

Eigen::MatrixXd Regression::of_candidate(const Candidate& candidate, const Try& tried,
                                         const Eigen::VectorXd& values) const {
  const PlantModel model = with_law(seen_.base, candidate.law);
  const Eigen::VectorXd all = with_parameters(values, tried.parameters);
  const Eigen::VectorXd without = column(seen_.base, values), with = column(model, all);
  if (with.size() == 0) return {};
  Eigen::MatrixXd columns(with.size(), 1 + static_cast<Eigen::Index>(tried.parameters.size()));
  columns.col(0) = with - without;
  for (Eigen::Index i = 1; i < columns.cols(); ++i) {
    Eigen::VectorXd moved = all;
    const double step = step_of(moved[values.size() + i - 1]);
    moved[values.size() + i - 1] += step;
    const Eigen::VectorXd there = column(model, moved);
    columns.col(i) = there.size() == with.size() ? Eigen::VectorXd((there - with) / step)
                                                 : Eigen::VectorXd(Eigen::VectorXd::Zero(with.size()));
  }
  return columns;
}

}  // namespace hidden_effects
