#include "fitting/head_fit.h"

#include "fitting/least_squares.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kWeak = 30.0;  ///< the guess pulls with so many times its deviation: enough to keep the search regular

/// Residuals of one head as a function of the unknown components of its start; no shared values.
class HeadProblem : public SegmentedProblem {
 public:
  HeadProblem(const TrialPredictor& predictor, const StartStates& states, const Stretch& head,
              std::span<const double> values, int worker)
      : predictor_(predictor), states_(states), head_(head), values_(values), worker_(worker) {
    guess_ = states.from_samples(head, head.first);
    for (int index = 0; index < guess_.deviation.size(); ++index)
      if (guess_.tells(index)) unknown_.push_back(index);
  }

  const StartEstimate& guess() const { return guess_; }
  const std::vector<int>& unknown() const { return unknown_; }

  FitPoint start() const {
    FitPoint point{Eigen::VectorXd(), {Eigen::VectorXd(static_cast<Eigen::Index>(unknown_.size()))}};
    for (std::size_t j = 0; j < unknown_.size(); ++j)
      point.states[0](static_cast<Eigen::Index>(j)) = component(guess_.start, unknown_[j]);
    return point;
  }
  StartState start_of(const Eigen::VectorXd& state) const {
    StartState start = guess_.start;
    for (std::size_t j = 0; j < unknown_.size(); ++j)
      set_component(start, unknown_[j], state(static_cast<Eigen::Index>(j)));
    return start;
  }

  const Eigen::VectorXd& lower() const override { return nothing_; }
  const Eigen::VectorXd& upper() const override { return nothing_; }
  Eigen::Index robust_rows(std::size_t) const override { return 0; }

  bool residuals(const FitPoint& point, std::vector<Eigen::VectorXd>& residuals) override {
    residuals.resize(1);
    return whitened(point.states[0], residuals[0]);
  }

  void linearize(const FitPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                 std::vector<SegmentJacobian>& jacobians) override {
    jacobians.resize(1);
    const Eigen::VectorXd& at = point.states[0];
    jacobians[0].values.resize(residuals[0].size(), 0);
    jacobians[0].state.setZero(residuals[0].size(), at.size());
    Eigen::VectorXd shifted;
    for (Eigen::Index j = 0; j < at.size(); ++j) {
      const double deviation = guess_.deviation(unknown_[static_cast<std::size_t>(j)]);
      const double step = std::max(0.1 * deviation, 1e-9 * std::max(1.0, std::abs(at(j))));
      Eigen::VectorXd moved = at;
      moved(j) += step;
      if (whitened(moved, shifted)) jacobians[0].state.col(j) = (shifted - residuals[0]) / step;
    }
  }

 private:
  bool whitened(const Eigen::VectorXd& state, Eigen::VectorXd& r) {
    predictor_.predict(head_, values_, start_of(state), worker_, prediction_);
    if (!prediction_.valid) return false;
    predictor_.residuals(head_, prediction_, difference_);
    r.resize(difference_.size() + state.size());
    Eigen::Index row = 0;
    for (Eigen::Index channel = 0; channel < difference_.cols(); ++channel)
      for (Eigen::Index i = 0; i < difference_.rows(); ++i) {
        const double value = difference_(i, channel) / states_.deviation(head_.trial, channel);
        r(row++) = std::isfinite(value) ? value : 0.0;
      }
    for (Eigen::Index j = 0; j < state.size(); ++j) {
      const int index = unknown_[static_cast<std::size_t>(j)];
      r(row++) = (state(j) - component(guess_.start, index)) / (kWeak * guess_.deviation(index));
    }
    return true;
  }

  const TrialPredictor& predictor_;
  const StartStates& states_;
  Stretch head_;
  std::span<const double> values_;
  int worker_;
  StartEstimate guess_;
  std::vector<int> unknown_;
  Eigen::VectorXd nothing_;
  Prediction prediction_;
  TimeSeries::Samples difference_;
};

Eigen::VectorXd deviations(const Eigen::MatrixXd& jacobian) {
  const Eigen::MatrixXd information = jacobian.transpose() * jacobian;
  const Eigen::VectorXd scale = information.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * information * scale.asDiagonal();
  const Eigen::MatrixXd covariance = scaled.ldlt().solve(Eigen::MatrixXd::Identity(scaled.rows(), scaled.cols()));
  return scale.cwiseProduct(covariance.diagonal().cwiseMax(0.0).cwiseSqrt());
}

}  // namespace

Eigen::Index head_end(const TrialPredictor& predictor, const Stretch& stretch, double length) {
  const Eigen::VectorXd& times = predictor.trials()[stretch.trial].measured.times;
  const double until = times(stretch.first) + length * (1.0 + 1e-9);
  Eigen::Index end = stretch.first;
  while (end < stretch.last && (times(end) <= until || end - stretch.first < kHeadSamples)) ++end;
  return end;
}

Eigen::Index first_scored(const TrialPredictor& predictor, const Stretch& stretch, const StartEstimate& estimate) {
  return estimate.known_from_data() ? head_end(predictor, stretch) : stretch.first;
}

StartEstimate fit_head(const TrialPredictor& predictor, const StartStates& states, const Stretch& stretch,
                       std::span<const double> values, int worker, double length) {
  const Stretch head{stretch.trial, stretch.first, head_end(predictor, stretch, length)};
  HeadProblem problem(predictor, states, head, values, worker);
  StartEstimate estimate = problem.guess();
  if (problem.unknown().empty()) return estimate;

  LeastSquaresOptions options;
  options.max_iterations = 8;
  const LeastSquaresResult best = minimize(problem, problem.start(), options);
  estimate.valid = best.valid;
  if (!best.valid) return estimate;
  estimate.start = problem.start_of(best.point.states[0]);
  std::vector<SegmentJacobian> jacobians;
  problem.linearize(best.point, best.residuals, jacobians);
  // A model that does not follow even the head is less certain of the start.
  estimate.misfit = std::sqrt(std::max(1.0, best.cost / static_cast<double>(best.residuals[0].size())));
  const Eigen::VectorXd certain = estimate.misfit * deviations(jacobians[0].state);
  for (std::size_t j = 0; j < problem.unknown().size(); ++j) {
    const int index = problem.unknown()[j];
    estimate.deviation(index) = std::max(certain(static_cast<Eigen::Index>(j)), estimate.noise(index));
  }
  return estimate;
}

}  // namespace lacuna
