#include "prediction/descent.h"

#include "prediction/whitened_columns.h"

#include <algorithm>
#include <utility>

namespace lacuna {
namespace {

constexpr double kTolerance = 3e-4;  ///< nats that a step gains
constexpr double kLeastDamping = 0.01, kMostDamping = 100.0;
constexpr double kPull = 3e-4;         ///< nats, that a value costs at a range's distance from where it starts
constexpr double kPullOfTiming = 0.1;  ///< nats, the same of when commands act, which a delay does as well
constexpr double kMoreDamping = 10.0;  ///< times, after a step that led to nothing

class Descent {
 public:
  explicit Descent(LadderPredictions& predictions)
      : predictions_(predictions), ladder_(predictions.ladder()), space_(predictions.space()) {}

  PredictionFit from(const PredictionPoint& start, int most, const StartDerivatives* like) {
    if (!predictions_.residuals(start, residuals_)) return fit_;
    linear_.stretches.resize(residuals_.size());
    if (like)
      for (std::size_t k = 0; k < residuals_.size(); ++k) linear_.stretches[k].start = like->at(k);
    else
      predictions_.linearise_starts(start, residuals_, linear_);
    predictions_.linearise_values(start, residuals_, linear_);
    fit_.valid = true;
    fit_.point = start;
    fit_.cost = cost_of(start.values, linear_.products);
    fit_.iterations = 1;
    if (go_down(most) || like) {
      predictions_.linearise_starts(fit_.point, residuals_, linear_);
      fit_.cost = cost_of(fit_.point.values, linear_.products);
      go_down(most);
    }
    fit_.products = std::move(linear_.products);
    for (LinearStretch& stretch : linear_.stretches) fit_.by_starts.push_back(std::move(stretch.start));
    fit_.bounds = bounds_at(fit_.point.values);
    return std::move(fit_);
  }

 private:
  double cost_of(const Eigen::VectorXd& values, const BlockProducts& products) const {
    const double of_way = bounds_at(values).cost_of_way(Eigen::VectorXd::Zero(values.size()));
    return of_way + cost_at(ladder_.layout, products, Eigen::VectorXd::Zero(products.values())).cost;
  }

  /// What hardly matters belongs where it starts: of two values that act alike, the wider stays free.
  StepBounds bounds_at(const Eigen::VectorXd& values) const {
    const Eigen::ArrayXd range = space_.upper() - space_.lower();
    Eigen::VectorXd pull = (range > 0.0).select(kPull / range.square(), 0.0);  // of what cannot move nothing
    if (predictions_.fits_timing()) pull.tail(1) *= kPullOfTiming / kPull;
    return {space_.lower() - values, space_.upper() - values, {}, space_.start() - values, pull};
  }

  /// Where the least cost is to first order, values and starts together.
  PredictionPoint stepped(double damping) const {
    const LinearCost best = least_cost(ladder_.layout, linear_.products, bounds_at(fit_.point.values), damping);
    const Eigen::VectorXd values = space_.clamp(fit_.point.values + best.step);
    return {values, moved_starts(ladder_, linear_, values - fit_.point.values)};
  }

  /// With the derivatives by starts of the point before.
  double cost_at_point(const PredictionPoint& point, const std::vector<Eigen::VectorXd>& residuals) const {
    std::vector<LinearStretch> stretches(linear_.stretches.size());
    for (std::size_t k = 0; k < stretches.size(); ++k) {
      stretches[k].start = linear_.stretches[k].start;
      stretches[k].values.resize(residuals[k].size(), 0);
    }
    predictions_.put_residuals(point, residuals, stretches);
    return cost_of(point.values, whitened_products(ladder_, stretches));
  }

  /// Steps until one gains hardly anything; whether any was taken.
  bool go_down(int most) {
    bool has_moved = false;
    double damping = 0.0;
    std::vector<Eigen::VectorXd> residuals;
    for (; fit_.iterations < most; ++fit_.iterations) {
      PredictionPoint next = stepped(damping);
      const bool is_valid = predictions_.residuals(next, residuals);
      const double cost = is_valid ? cost_at_point(next, residuals) : 0.0;
      if (!is_valid || cost >= fit_.cost) {
        damping = std::max(kLeastDamping, kMoreDamping * damping);
        if (damping > kMostDamping) break;
        continue;
      }
      has_moved = true;
      const double gain = fit_.cost - cost;
      fit_.point = std::move(next);
      fit_.cost = cost;
      residuals_.swap(residuals);
      predictions_.linearise_values(fit_.point, residuals_, linear_);
      damping = damping > kLeastDamping ? damping / kMoreDamping : 0.0;
      if (gain < kTolerance) break;
    }
    return has_moved;
  }

  LadderPredictions& predictions_;
  const PredictionLadder& ladder_;
  const ParameterSpace& space_;
  PredictionFit fit_;
  LinearPrediction linear_;
  std::vector<Eigen::VectorXd> residuals_;  ///< at the point of the fit
};

}  // namespace

PredictionFit descend(LadderPredictions& predictions, const PredictionPoint& start, int most,
                      const StartDerivatives* like) {
  return Descent(predictions).from(start, most, like);
}

}  // namespace lacuna
