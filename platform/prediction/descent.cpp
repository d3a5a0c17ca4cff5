#include "prediction/descent.h"

#include "prediction/whitened_columns.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace lacuna {
namespace {

constexpr double kTolerance = 3e-4;  ///< nats by which a step must lower the cost
constexpr double kPromised = 3e-5;   ///< nats: a step with less predicted gain is not tried
constexpr double kLeastDamping = 0.01, kMostDamping = 100.0;
constexpr double kPull = 3e-4;         ///< nats, penalty of a value at a distance of one range from its start
constexpr double kPullOfTiming = 0.1;  ///< nats, the same for the timestamp offset, which acts like a delay
constexpr double kMoreDamping = 10.0;  ///< factor on the damping after a step that failed

class Descent {
 public:
  explicit Descent(LadderPredictions& predictions)
      : predictions_(predictions), ladder_(predictions.ladder()), space_(predictions.space()) {}

  PredictionFit from(const PredictionPoint& start, int most, const LikeModel& like,
                     const std::vector<std::string>& names, LastSteps last) {
    if (!predictions_.residuals(start, residuals_)) return fit_;
    linear_.stretches.resize(residuals_.size());
    if (like.empty())
      predictions_.linearise_starts(start, residuals_, linear_);
    else
      take(like, names);
    fit_.valid = true;
    fit_.point = start;
    linearise_values();
    const bool is_down = go_down(most);
    if (!is_down || last == LastSteps::anew) {
      stays_.clear();
      predictions_.forget_steps();
      if (last == LastSteps::anew) predictions_.linearise_starts(fit_.point, residuals_, linear_);
      linearise_values();
      go_down(most);
    }
    fit_.products = std::move(linear_.products);
    for (LinearStretch& stretch : linear_.stretches) {
      fit_.by_starts.push_back(std::move(stretch.start));
      fit_.by_values.push_back(std::move(stretch.values));
    }
    fit_.bounds = bounds_at(fit_.point.values);
    return std::move(fit_);
  }

 private:
  /// The derivatives taken from a similar model; those by other values must be computed.
  void take(const LikeModel& like, const std::vector<std::string>& names) {
    stays_.assign(static_cast<std::size_t>(space_.size()), false);
    for (std::size_t k = 0; k < residuals_.size(); ++k) {
      linear_.stretches[k].start = like.by_starts[k];
      linear_.stretches[k].values = Eigen::MatrixXd::Zero(residuals_[k].size(), space_.size());
    }
    for (std::size_t j = 0; j < names.size(); ++j) {
      const auto same = std::find(like.values.begin(), like.values.end(), names[j]);
      if (same == like.values.end()) continue;
      stays_[j] = true;
      for (std::size_t k = 0; k < residuals_.size(); ++k)
        linear_.stretches[k].values.col(static_cast<Eigen::Index>(j)) =
            like.by_values[k].col(same - like.values.begin());
    }
  }

  void linearise_values() {
    predictions_.linearise_values(fit_.point, residuals_, linear_, stays_);
    fit_.cost = cost_of(fit_.point.values, linear_.products);
  }

  double cost_of(const Eigen::VectorXd& values, const BlockProducts& products) const {
    const double of_way = bounds_at(values).cost_of_way(Eigen::VectorXd::Zero(values.size()));
    return of_way + cost_at(ladder_.layout, products, Eigen::VectorXd::Zero(products.values())).cost;
  }

  /// Values that hardly matter stay at their start: of two values with the same influence, the one with the wider range
  /// stays free.
  StepBounds bounds_at(const Eigen::VectorXd& values) const {
    const Eigen::ArrayXd range = space_.upper() - space_.lower();
    Eigen::VectorXd pull = (range > 0.0).select(kPull / range.square(), 0.0);  // of a value that cannot move, none
    if (predictions_.fits_timing()) pull.tail(1) *= kPullOfTiming / kPull;
    return {space_.lower() - values, space_.upper() - values, {}, space_.start() - values, pull};
  }

  /// The step to the smallest first-order cost; nothing where its gain is too small.
  std::optional<Eigen::VectorXd> next_step(double damping) const {
    const StepBounds bounds = bounds_at(fit_.point.values);
    const LinearCost best = least_cost(ladder_.layout, linear_.products, bounds, damping);
    const double least = stays_.empty() ? kPromised : kTolerance;
    if (fit_.cost - best.cost - bounds.cost_of_way(best.step) < least) return std::nullopt;
    return best.step;
  }

  /// Values and starts together.
  PredictionPoint moved_by(const Eigen::VectorXd& step) const {
    const Eigen::VectorXd values = space_.clamp(fit_.point.values + step);
    return {values, moved_starts(ladder_, linear_, values - fit_.point.values)};
  }

  /// With the derivatives by initial states from the previous point.
  double cost_at_point(const PredictionPoint& point, const std::vector<Eigen::VectorXd>& residuals) const {
    std::vector<LinearStretch> stretches(linear_.stretches.size());
    for (std::size_t k = 0; k < stretches.size(); ++k) {
      stretches[k].start = linear_.stretches[k].start;
      stretches[k].values.resize(residuals[k].size(), 0);
    }
    predictions_.put_residuals(point, residuals, stretches);
    return cost_of(point.values, whitened_products(ladder_, stretches));
  }

  /// Steps until the gain is too small. False: the derivatives of a similar model led nowhere, or the number of steps
  /// ran out.
  bool go_down(int most) {
    double damping = 0.0;
    std::vector<Eigen::VectorXd> residuals;
    for (int step = 1; step < most; ++step, ++fit_.iterations) {
      const std::optional<Eigen::VectorXd> way = next_step(damping);
      if (!way && damping == 0.0) return true;
      if (!way) break;
      PredictionPoint next = moved_by(*way);
      const bool is_valid = predictions_.residuals(next, residuals);
      const double cost = is_valid ? cost_at_point(next, residuals) : 0.0;
      if (!is_valid || cost >= fit_.cost) {
        if (!stays_.empty()) break;
        damping = std::max(kLeastDamping, kMoreDamping * damping);
        if (damping > kMostDamping) break;
        continue;
      }
      const double gain = fit_.cost - cost;
      fit_.point = std::move(next);
      fit_.cost = cost;
      residuals_.swap(residuals);
      predictions_.linearise_values(fit_.point, residuals_, linear_, stays_);
      damping = damping > kLeastDamping ? damping / kMoreDamping : 0.0;
      if (gain < kTolerance) return true;
    }
    return false;
  }

  LadderPredictions& predictions_;
  const PredictionLadder& ladder_;
  const ParameterSpace& space_;
  PredictionFit fit_;
  LinearPrediction linear_;
  std::vector<Eigen::VectorXd> residuals_;  ///< at the fitted point
  std::vector<bool> stays_;                 ///< by value: whether its derivative comes from a similar model
};

}  // namespace

PredictionFit descend(LadderPredictions& predictions, const PredictionPoint& start, int most, const LikeModel& like,
                      const std::vector<std::string>& names, LastSteps last) {
  return Descent(predictions).from(start, most, like, names, last);
}

}  // namespace lacuna
