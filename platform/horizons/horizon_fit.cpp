#include "horizons/horizon_fit.h"

#include "horizons/linear_ladder.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace lacuna {
namespace {

constexpr int kMostSteps = 12;
constexpr int kStepsOnTheWay = 4;    ///< up the ladder, whose short predictions lead to the long ones
constexpr double kTolerance = 3e-3;  ///< nats that a further step would gain
constexpr double kOneBlock = 1e9;    ///< s: of blocks nothing is asked here
constexpr double kLeastDamping = 0.03, kMostDamping = 1000.0;
constexpr double kMoreDamping = 10.0;  ///< times, after a step that led to nothing

/// Residuals in channel units, of what a problem divides by its scales.
std::vector<Eigen::VectorXd> in_units(const ShootingProblem& problem, std::vector<Eigen::VectorXd> residuals) {
  for (std::size_t k = 0; k < residuals.size(); ++k)
    for (std::size_t r = 0; r < problem.segments()[k].rows.size(); ++r) {
      const auto row = static_cast<Eigen::Index>(r);
      residuals[k](row) *= problem.scales()[problem.place(k, row).channel];
    }
  return residuals;
}

/// A fit's values and starts after a step.
FitPoint moved(const HorizonFit& fit, const ParameterSpace& space, const LadderStep& step) {
  FitPoint point{space.clamp(space.to_coordinates(fit.values) + step.values), fit.states};
  for (std::size_t k = 0; k < point.states.size(); ++k)
    if (step.states[k].size() > 0) point.states[k] += step.states[k];
  return point;
}

/// One over the readings of the channel that a rung has most of: the cost is a mean, against which priors of starts are
/// weighed.
double weight_of_priors(const Ladder& ladder) {
  double most = 1.0;
  for (const Rung& rung : ladder.rungs) {
    std::map<Eigen::Index, double> counts;
    for (const Segment& segment : rung.segments)
      for (const Eigen::Index column : segment.columns) most = std::max(most, counts[column] += 1.0);
  }
  return 1.0 / most;
}

/// Predictions on one ladder, judged.
class Judge {
 public:
  Judge(const Ladder& ladder, const TrialPredictor& predictor, const ParameterSpace& space)
      : ladder_(ladder),
        predictor_(predictor),
        space_(space),
        problem_(predictor, space, all_segments(ladder), ladder.channels) {}

  FitPoint start(const std::vector<double>& values) const {
    return problem_.start(space_.clamp(space_.to_coordinates(values)));
  }

  HorizonErrors errors(const FitPoint& at) {
    if (!problem_.residuals(at, residuals_)) return {};
    residuals_ = in_units(problem_, std::move(residuals_));
    return horizon_errors(ladder_, predictor_.trials(), residuals_);
  }

  /// Makes that point, which was judged last, the fit.
  void keep(const FitPoint& point, const HorizonErrors& errors, HorizonFit& fit) const {
    fit.errors = errors;
    fit.values = space_.to_values(point.values);
    fit.states = point.states;
    fit.residuals = residuals_;
  }

  std::uint64_t simulations() const { return problem_.simulations(); }

 private:
  const Ladder& ladder_;
  const TrialPredictor& predictor_;
  const ParameterSpace& space_;
  ShootingProblem problem_;
  std::vector<Eigen::VectorXd> residuals_;
};

/// Steps on one ladder, from `values`; the best is left in `fit`.
void descend(const Ladder& ladder, const TrialPredictor& predictor, const ParameterSpace& space, int steps,
             HorizonFit& fit) {
  Judge judge(ladder, predictor, space);
  fit.prior_weight = weight_of_priors(ladder);
  const FitPoint start = judge.start(fit.values);
  judge.keep(start, judge.errors(start), fit);
  double damping = 0.0;
  for (int i = 0; fit.errors.valid && i < steps; ++i) {
    const LinearLadder linear = linearise(ladder, predictor, space, fit, kOneBlock);
    ++fit.iterations;
    if (linear.step(0.0).gain < kTolerance) break;
    const double before = fit.errors.cost;
    for (; damping < kMostDamping; damping = std::max(kLeastDamping, kMoreDamping * damping)) {
      const FitPoint point = moved(fit, space, linear.step(damping));
      const HorizonErrors now = judge.errors(point);
      if (!now.valid || now.cost >= before) continue;
      judge.keep(point, now, fit);
      break;
    }
    if (before - fit.errors.cost < kTolerance) break;
    damping = damping > kLeastDamping ? damping / kMoreDamping : 0.0;
  }
  fit.simulations += judge.simulations();
}

}  // namespace

HorizonFit fit_to_ladder(const Ladder& ladder, const TrialPredictor& predictor, const ParameterSpace& space,
                         const std::vector<double>& start, Climb climb) {
  HorizonFit fit;
  fit.values = start;
  for (std::size_t rungs = 1; climb == Climb::from_the_bottom && rungs < ladder.rungs.size(); rungs += 2)
    descend(first_rungs(ladder, rungs), predictor, space, kStepsOnTheWay, fit);
  descend(ladder, predictor, space, kMostSteps, fit);
  return fit;
}

HorizonFit fit_at(const Ladder& ladder, const TrialPredictor& predictor, const ParameterSpace& space,
                  const std::vector<double>& values, const std::vector<Eigen::VectorXd>& states) {
  Judge judge(ladder, predictor, space);
  HorizonFit fit;
  fit.prior_weight = weight_of_priors(ladder);
  FitPoint point = judge.start(values);
  if (states.size() == point.states.size()) point.states = states;
  judge.keep(point, judge.errors(point), fit);
  fit.values = values;  // digit for digit
  fit.simulations = judge.simulations();
  return fit;
}

HorizonErrors errors_on(const Ladder& ladder, const TrialPredictor& predictor, const ParameterSpace& space,
                        const std::vector<double>& values) {
  Judge judge(ladder, predictor, space);
  return judge.errors(judge.start(values));
}

}  // namespace lacuna
