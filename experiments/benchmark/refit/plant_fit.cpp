#include "refit/plant_fit.h"

#include "refit/difference_steps.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace hidden_effects {
namespace {

constexpr double kFirstDamping = 1e-4, kMostDamping = 1e8;

using Index = Eigen::Index;

Eigen::MatrixXd differences(const Readings& measured, const Readings& predicted) {
  Eigen::MatrixXd table(static_cast<Index>(measured.front().size()), static_cast<Index>(measured.size()));
  for (std::size_t s = 0; s < measured.size(); ++s)
    for (std::size_t k = 0; k < measured[s].size(); ++k)
      table(static_cast<Index>(k), static_cast<Index>(s)) = measured[s][k] - predicted[s][k];
  return table;
}

/// The normal equations of one trial, the start's unknowns last, eliminated after the damping.
struct TrialSystem {
  Eigen::MatrixXd own, mixed, of_start;  ///< values × values, values × start, start × start
  Eigen::VectorXd gradient, start_gradient;
};

class Fitter {
 public:
  Fitter(const PlantModel& model, const std::vector<FittedTrial>& trials, const Whiten& whiten,
         const FitOptions& options)
      : model_(model), trials_(trials), whiten_(whiten), options_(options) {}

  PlantFit run(const Eigen::VectorXd& values, std::vector<Start> starts) {
    PlantFit fit;
    fit.values = values;
    fit.starts = std::move(starts);
    if (!evaluate(fit)) return fit;
    double damping = kFirstDamping;
    for (int i = 0; i < options_.most_iterations; ++i) {
      linearise(fit);
      const double before = fit.deviance;
      if (!improve(fit, damping)) break;
      if (before - fit.deviance < options_.enough * static_cast<double>(fit.rows)) break;
      if (fit.deviance < options_.settled || fit.deviance > (1.0 - options_.hopeless) * before) break;
    }
    if (options_.wants_information) {
      linearise(fit);
      describe(fit);
    }
    fit.valid = true;
    return fit;
  }

 private:
  bool evaluate(PlantFit& fit) const {
    fit.deviance = 0.0;
    fit.rows = 0;
    fit.residuals.clear();
    try {
      for (std::size_t t = 0; t < trials_.size(); ++t) {
        fit.residuals.push_back(residual(t, fit.values, fit.starts[t]));
        fit.deviance += fit.residuals.back().squaredNorm();
        fit.rows += static_cast<std::size_t>(fit.residuals.back().size());
      }
    } catch (const std::runtime_error&) {
      return false;
    }
    return std::isfinite(fit.deviance);
  }

  Eigen::VectorXd residual(std::size_t t, const Eigen::VectorXd& values, const Start& start) const {
    const FittedTrial& trial = trials_[t];
    return whiten_(t, differences(trial.readings, predict(model_, values, trial.excitation, start, options_.step)));
  }

  Eigen::VectorXd derivative(const Eigen::VectorXd& base, std::size_t t, const Eigen::VectorXd& values,
                             const Start& start, double step) const {
    try {
      return (residual(t, values, start) - base) / step;
    } catch (const std::runtime_error&) {
      return Eigen::VectorXd::Zero(base.size());
    }
  }

  void linearise(const PlantFit& fit) {
    systems_.clear();
    const Index count = fit.values.size();
    for (std::size_t t = 0; t < trials_.size(); ++t) {
      const Eigen::VectorXd& base = fit.residuals[t];
      const Index joints = options_.free_starts ? fit.starts[t].position.size() : 0;
      Eigen::MatrixXd of_values(base.size(), count), of_start(base.size(), 2 * joints);
      for (Index i = 0; i < count; ++i) {
        Eigen::VectorXd moved = fit.values;
        const double step = std::max(kRelativeStep * std::abs(moved[i]), kLeastStep);
        moved[i] += step;
        of_values.col(i) = derivative(base, t, moved, fit.starts[t], step);
      }
      for (Index i = 0; i < 2 * joints; ++i) {
        Start moved = fit.starts[t];
        (i < joints ? moved.position[i] : moved.velocity[i - joints]) += kStartStep;
        of_start.col(i) = derivative(base, t, fit.values, moved, kStartStep);
      }
      systems_.push_back({of_values.transpose() * of_values, of_values.transpose() * of_start,
                          of_start.transpose() * of_start, -(of_values.transpose() * base),
                          -(of_start.transpose() * base)});
    }
  }

  bool improve(PlantFit& fit, double& damping) const {
    for (; damping < kMostDamping; damping *= 10.0) {
      PlantFit next = fit;
      take(next, damping);
      if (!evaluate(next) || next.deviance >= fit.deviance) continue;
      fit = std::move(next);
      damping = std::max(1e-9, damping / 10.0);
      return true;
    }
    return false;
  }

  /// A damped Gauss-Newton step, the starts eliminated trial by trial.
  void take(PlantFit& fit, double damping) const {
    const Index count = fit.values.size();
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
    std::vector<Eigen::LDLT<Eigen::MatrixXd>> of_starts;
    for (const TrialSystem& one : systems_) {
      of_starts.emplace_back(damped(one.of_start, damping));
      normal += one.own - one.mixed * of_starts.back().solve(one.mixed.transpose());
      right += one.gradient - one.mixed * of_starts.back().solve(one.start_gradient);
    }
    const Eigen::VectorXd step = damped(normal, damping).ldlt().solve(right);
    fit.values += step;
    if (options_.lower.size() > 0) fit.values = fit.values.cwiseMax(options_.lower).cwiseMin(options_.upper);
    for (std::size_t t = 0; t < systems_.size(); ++t) {
      const Index joints = systems_[t].of_start.rows() / 2;
      if (joints == 0) continue;
      const Eigen::VectorXd of_start =
          of_starts[t].solve(systems_[t].start_gradient - systems_[t].mixed.transpose() * step);
      fit.starts[t].position += of_start.head(joints);
      fit.starts[t].velocity += of_start.tail(joints);
    }
  }

  static Eigen::MatrixXd damped(Eigen::MatrixXd matrix, double damping) {
    for (Index i = 0; i < matrix.rows(); ++i)
      matrix(i, i) += damping * matrix(i, i) + std::numeric_limits<double>::min();
    return matrix;
  }

  void describe(PlantFit& fit) const {
    const Index count = fit.values.size();
    fit.information = Eigen::MatrixXd::Zero(count, count);
    for (const TrialSystem& one : systems_)
      fit.information += one.own - one.mixed * damped(one.of_start, 1e-12).ldlt().solve(one.mixed.transpose());
  }

  const PlantModel& model_;
  const std::vector<FittedTrial>& trials_;
  const Whiten& whiten_;
  const FitOptions& options_;
  std::vector<TrialSystem> systems_;
};

}  // namespace

double PlantFit::rms() const { return std::sqrt(deviance / static_cast<double>(std::max<std::size_t>(rows, 1))); }

Whiten by_deviation(std::vector<double> deviations) {
  return [deviations = std::move(deviations)](std::size_t, const Eigen::MatrixXd& differences) {
    Eigen::MatrixXd scaled = differences;
    for (Index s = 0; s < scaled.cols(); ++s) scaled.col(s) /= deviations[static_cast<std::size_t>(s)];
    return Eigen::VectorXd(Eigen::Map<Eigen::VectorXd>(scaled.data(), scaled.size()));
  };
}

PlantFit fit_plant(const PlantModel& model, const std::vector<FittedTrial>& trials, const Eigen::VectorXd& values,
                   std::vector<Start> starts, const Whiten& whiten, const FitOptions& options) {
  return Fitter(model, trials, whiten, options).run(values, std::move(starts));
}

}  // namespace hidden_effects
