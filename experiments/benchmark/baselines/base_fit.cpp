#include "baselines/base_fit.h"

#include "refit/difference_steps.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hidden_effects {
namespace {

constexpr double kFirstStretch = 0.05;  ///< s
constexpr double kFirstShare = 0.1;     ///< of a signal's size: its error before anything is fitted
constexpr int kPasses = 2;

double rms_about_mean(const std::vector<double>& values) {
  const Eigen::Map<const Eigen::VectorXd> x(values.data(), static_cast<Eigen::Index>(values.size()));
  return std::sqrt((x.array() - x.mean()).square().mean());
}

std::vector<double> first_deviations(const Observed& seen) {
  std::vector<double> deviations(seen.base.spec.sensors.size(), 0.0);
  for (const FittedTrial& trial : seen.trials)
    for (std::size_t s = 0; s < deviations.size(); ++s)
      deviations[s] = std::max(deviations[s], kFirstShare * rms_about_mean(trial.readings[s]));
  for (double& deviation : deviations) deviation = deviation > 0.0 ? deviation : 1.0;
  return deviations;
}

/// By sensor, in the readings' unit; residuals hold the sensors of a trial one below the other.
std::vector<double> left_by_sensor(const PlantFit& fit, std::vector<double> deviations) {
  const auto sensors = static_cast<Eigen::Index>(deviations.size());
  for (Eigen::Index s = 0; s < sensors; ++s) {
    double squares = 0.0, count = 0.0;
    for (const Eigen::VectorXd& residual : fit.residuals) {
      const Eigen::Index rows = residual.size() / sensors;
      squares += residual.segment(s * rows, rows).squaredNorm();
      count += static_cast<double>(rows);
    }
    deviations[static_cast<std::size_t>(s)] *= std::max(std::sqrt(squares / count), 1e-12);
  }
  return deviations;
}

PlantFit fitted(const Observed& seen, const Eigen::VectorXd& values, const std::vector<Start>& starts,
                const std::vector<double>& deviations) {
  FitOptions options;
  options.most_iterations = 30;
  return fit_plant(seen.base, seen.trials, values, starts, by_deviation(deviations), options);
}

}  // namespace

Start first_start(const PlantSpec& spec, const FittedTrial& trial) {
  const auto joints = static_cast<Eigen::Index>(spec.joints.size());
  Start start{Coordinates::Zero(joints), Coordinates::Zero(joints)};
  const double interval = trial.excitation.interval;
  for (std::size_t s = 0; s < spec.sensors.size(); ++s) {
    if (spec.sensors[s].velocity) continue;
    const std::size_t count =
        std::clamp<std::size_t>(static_cast<std::size_t>(kFirstStretch / interval) + 1, 2, trial.readings[s].size());
    const double middle = 0.5 * static_cast<double>(count - 1) * interval;
    double mean = 0.0, slope = 0.0, squares = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      const double time = static_cast<double>(k) * interval - middle;
      mean += trial.readings[s][k] / static_cast<double>(count);
      slope += time * trial.readings[s][k];
      squares += time * time;
    }
    start.velocity[spec.sensors[s].joint] = slope / squares;
    start.position[spec.sensors[s].joint] = mean - middle * slope / squares;
  }
  return start;
}

BaseFit fit_base(const Observed& seen, const std::vector<Eigen::VectorXd>& beginnings) {
  BaseFit base{first_deviations(seen), {}};
  std::vector<Start> starts;
  for (const FittedTrial& trial : seen.trials) starts.push_back(first_start(seen.base.spec, trial));
  for (const Eigen::VectorXd& values : beginnings) {
    PlantFit fit = fitted(seen, values, starts, base.deviations);
    if (fit.valid && (!base.fit.valid || fit.deviance < base.fit.deviance)) base.fit = std::move(fit);
  }
  if (!base.fit.valid) throw std::runtime_error("the base runs away");
  for (int pass = 0; pass < kPasses; ++pass) {
    base.deviations = left_by_sensor(base.fit, base.deviations);
    base.fit = fitted(seen, base.fit.values, base.fit.starts, base.deviations);
  }
  return base;
}

Eigen::VectorXd whitened_prediction(const PlantModel& model, const Eigen::VectorXd& values,
                                    const std::vector<FittedTrial>& trials, const std::vector<Start>& starts,
                                    const std::vector<double>& deviations) {
  std::vector<double> all;
  try {
    for (std::size_t t = 0; t < trials.size(); ++t) {
      const Readings readings = predict(model, values, trials[t].excitation, starts[t]);
      for (std::size_t s = 0; s < readings.size(); ++s)
        for (const double reading : readings[s]) all.push_back(reading / deviations[s]);
    }
  } catch (const std::runtime_error&) {
    return {};
  }
  return Eigen::Map<Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

Eigen::MatrixXd base_directions(const Observed& seen, const BaseFit& base) {
  const PlantFit& fit = base.fit;
  const auto predicted = [&](const Eigen::VectorXd& values, const std::vector<Start>& starts) {
    return whitened_prediction(seen.base, values, seen.trials, starts, base.deviations);
  };
  const Eigen::VectorXd middle = predicted(fit.values, fit.starts);
  const Eigen::Index joints = fit.starts.front().position.size();
  const auto trials = static_cast<Eigen::Index>(fit.starts.size()), rows = middle.size();
  Eigen::MatrixXd directions = Eigen::MatrixXd::Zero(rows, fit.values.size() + 2 * joints * trials);
  for (Eigen::Index i = 0; i < fit.values.size(); ++i) {
    Eigen::VectorXd moved = fit.values;
    const double step = std::max(kRelativeStep * std::abs(moved[i]), kLeastStep);
    moved[i] += step;
    const Eigen::VectorXd there = predicted(moved, fit.starts);
    if (there.size() == rows) directions.col(i) = (there - middle) / step;
  }
  for (Eigen::Index i = 0; i < 2 * joints; ++i) {  // all trials at once: their rows are apart
    std::vector<Start> moved = fit.starts;
    for (Start& start : moved) (i < joints ? start.position[i] : start.velocity[i - joints]) += kStartStep;
    const Eigen::VectorXd there = predicted(fit.values, moved);
    if (there.size() != rows) continue;
    Eigen::Index row = 0;
    for (Eigen::Index t = 0; t < trials; ++t) {
      const Eigen::Index count = fit.residuals[static_cast<std::size_t>(t)].size();
      directions.col(fit.values.size() + 2 * joints * t + i).segment(row, count) =
          (there - middle).segment(row, count) / kStartStep;
      row += count;
    }
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(directions);
  return factors.householderQ() * Eigen::MatrixXd::Identity(rows, factors.rank());
}

Eigen::VectorXd stacked(const std::vector<Eigen::VectorXd>& residuals) {
  Eigen::Index rows = 0;
  for (const Eigen::VectorXd& one : residuals) rows += one.size();
  Eigen::VectorXd all(rows);
  rows = 0;
  for (const Eigen::VectorXd& one : residuals) {
    all.segment(rows, one.size()) = one;
    rows += one.size();
  }
  return all;
}

}  // namespace hidden_effects
