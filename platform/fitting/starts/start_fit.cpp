#include "fitting/starts/start_fit.h"

#include "fitting/numerics/least_squares.h"
#include "fitting/numerics/local_polynomial.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kWeak = 30.0;    ///< width of the prior around the guess, in its deviations: keeps the search regular
constexpr double kShorter = 0.7;  ///< factor by which an axis that the data contradict is shortened
constexpr int kMostShorter = 30;  ///< times, together 1/40 000
constexpr double kAllowance = 2.0;  ///< squared error that one deviation may add, over that of a linear model

/// Residuals of the first samples as a function of the unknown components of their initial state; no shared values.
class HeadProblem : public SegmentedProblem {
 public:
  HeadProblem(const TrialPredictor& predictor, const StartStates& states, const Stretch& head,
              std::span<const double> values, int worker)
      : predictor_(predictor), states_(states), head_(head), values_(values), worker_(worker) {
    guess_ = states.from_samples(head, head.first);
    for (int index = 0; index < guess_.deviation.size(); ++index)
      if (guess_.tells(index)) unknown_.push_back(index);
    const TimeSeries& measured = predictor.trials()[head.trial].measured;
    for (Eigen::Index channel = 0; channel < measured.samples.cols(); ++channel)
      deviations_.push_back(states.deviation(head.trial, channel) *
                            repetition(measured, channel, {head.first, head.last}));
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

  /// RMS of the residuals over their noise, of readings and prior together.
  double misfit(const Eigen::VectorXd& residuals) const {
    double squares = residuals.tail(static_cast<Eigen::Index>(unknown_.size())).squaredNorm();
    const Eigen::Index rows = head_.size();
    for (std::size_t channel = 0; channel < deviations_.size(); ++channel) {
      const double repeated = deviations_[channel] / states_.deviation(head_.trial, static_cast<Eigen::Index>(channel));
      squares += repeated * repeated * residuals.segment(static_cast<Eigen::Index>(channel) * rows, rows).squaredNorm();
    }
    return std::sqrt(squares / static_cast<double>(residuals.size()));
  }

  /// Squared residuals at a state; infinite where it cannot be simulated.
  double cost(const Eigen::VectorXd& state) {
    Eigen::VectorXd residuals;
    return whitened(state, residuals) ? residuals.squaredNorm() : std::numeric_limits<double>::infinity();
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
        const double value = difference_(i, channel) / deviations_[static_cast<std::size_t>(channel)];
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
  std::vector<double> deviations_;  ///< per measured channel, of readings as if they were independent
  Eigen::VectorXd nothing_;
  Prediction prediction_;
  TimeSeries::Samples difference_;
};

/// Directions of uncertainty of a linear problem's solution, each one standard deviation long, in columns.
Eigen::MatrixXd principal_axes(const Eigen::MatrixXd& jacobian) {
  const Eigen::VectorXd scale = jacobian.colwise().norm().cwiseInverse();
  const Eigen::MatrixXd scaled = jacobian * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled.transpose() * scaled);
  const double least = std::numeric_limits<double>::epsilon() * eigen.eigenvalues().maxCoeff();
  const Eigen::VectorXd lengths = eigen.eigenvalues().cwiseMax(least).cwiseSqrt().cwiseInverse();
  return scale.asDiagonal() * eigen.eigenvectors() * lengths.asDiagonal();
}

/// Shortens an axis until the data agree with a start at its end. Where a joint sticks, small velocities change nothing
/// and the derivative shows no limit, but larger ones break away and contradict the data.
Eigen::VectorXd believable(HeadProblem& problem, const FitPoint& best, double allowed, Eigen::VectorXd axis) {
  for (int k = 0; k < kMostShorter; ++k) {
    const Eigen::VectorXd& at = best.states[0];
    if (std::max(problem.cost(at + axis), problem.cost(at - axis)) <= allowed) break;
    axis *= kShorter;
  }
  return axis;
}

}  // namespace

Eigen::Index head_end(const TrialPredictor& predictor, const Stretch& stretch, double length) {
  const Eigen::VectorXd& times = predictor.trials()[stretch.trial].measured.times;
  const double until = times(stretch.first) + length * (1.0 + 1e-9);
  Eigen::Index end = stretch.first;
  while (end < stretch.last && (times(end) <= until || end - stretch.first < kHeadSamples)) ++end;
  return end;
}

Eigen::Index first_scored(const TrialPredictor& predictor, const Stretch& stretch, const StartEstimate& estimate,
                          double memory) {
  const Eigen::Index first = estimate.known_from_data() ? head_end(predictor, stretch) : stretch.first;
  if (stretch.first > 0 || memory == 0.0 || !predictor.past_is_unknown(stretch.trial)) return first;
  const Eigen::VectorXd& times = predictor.trials()[stretch.trial].measured.times;
  const double until = times(0) + memory * (1.0 + 1e-9);
  const Eigen::Index remembered = std::upper_bound(times.data(), times.data() + stretch.last, until) - times.data();
  return std::max(first, remembered);
}

Eigen::Index first_scored(const TrialPredictor& predictor, const Stretch& stretch, const StartEstimate& estimate) {
  return first_scored(predictor, stretch, estimate, predictor.model().has_memory() ? kLongestMemory : 0.0);
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
  // A model that does not follow even the first samples is less certain of its start.
  estimate.misfit = std::max(1.0, problem.misfit(best.residuals[0]));
  const Eigen::MatrixXd axes = estimate.misfit * principal_axes(jacobians[0].state);
  const double allowed = best.residuals[0].squaredNorm() + kAllowance * estimate.misfit * estimate.misfit;
  estimate.axes.setZero(estimate.axes.rows(), axes.cols());
  for (Eigen::Index axis = 0; axis < axes.cols(); ++axis) {
    const Eigen::VectorXd bounded = believable(problem, best.point, allowed, axes.col(axis));
    for (std::size_t j = 0; j < problem.unknown().size(); ++j)
      estimate.axes(problem.unknown()[j], axis) = bounded(static_cast<Eigen::Index>(j));
  }
  for (const int index : problem.unknown()) estimate.deviation(index) = estimate.axes.row(index).norm();
  return estimate;
}

}  // namespace lacuna
