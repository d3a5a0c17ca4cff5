#include "horizons/horizon_fit.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr int kMostRounds = 6;
constexpr int kStepsARound = 2;
constexpr int kRoundsOnTheWay = 3;      ///< up the ladder, whose short predictions lead to the long ones
constexpr double kTolerance = 5e-4;     ///< nats a round
constexpr double kWinsorRow = 4.0;      ///< rms
constexpr double kLeastWeight = 1e-12;  ///< of rows that do not count: what is divided by a weight stays finite

/// Residuals in channel units, of what a problem divides by its scales.
std::vector<Eigen::VectorXd> in_units(const ShootingProblem& problem, std::vector<Eigen::VectorXd> residuals) {
  for (std::size_t k = 0; k < residuals.size(); ++k)
    for (std::size_t r = 0; r < problem.segments()[k].rows.size(); ++r) {
      const auto row = static_cast<Eigen::Index>(r);
      residuals[k](row) *= problem.scales()[problem.place(k, row).channel];
    }
  return residuals;
}

/// The shooting problem with a weight a row.
class WeightedProblem : public SegmentedProblem {
 public:
  explicit WeightedProblem(ShootingProblem& inner) : inner_(inner) {
    for (const Segment& segment : inner.segments())
      weights_.push_back(Eigen::VectorXd::Ones(static_cast<Eigen::Index>(segment.rows.size())));
  }
  std::vector<Eigen::VectorXd>& weights() { return weights_; }

  const Eigen::VectorXd& lower() const override { return inner_.lower(); }
  const Eigen::VectorXd& upper() const override { return inner_.upper(); }
  Eigen::Index robust_rows(std::size_t k) const override { return inner_.robust_rows(k); }
  bool residuals(const FitPoint& point, std::vector<Eigen::VectorXd>& residuals) override {
    if (!inner_.residuals(point, residuals)) return false;
    for (std::size_t k = 0; k < weights_.size(); ++k)
      residuals[k].head(weights_[k].size()).array() *= weights_[k].array();
    return true;
  }
  void linearize(const FitPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                 std::vector<SegmentJacobian>& jacobians) override {
    std::vector<Eigen::VectorXd> plain = residuals;
    for (std::size_t k = 0; k < weights_.size(); ++k)
      for (Eigen::Index r = 0; r < weights_[k].size(); ++r) plain[k](r) /= weights_[k](r);
    inner_.linearize(point, plain, jacobians);
    for (std::size_t k = 0; k < weights_.size(); ++k)
      for (Eigen::MatrixXd* part : {&jacobians[k].values, &jacobians[k].state})
        if (part->cols() > 0) part->topRows(weights_[k].size()).array().colwise() *= weights_[k].array();
  }

 private:
  ShootingProblem& inner_;
  std::vector<Eigen::VectorXd> weights_;
};

/// Readings of each channel in the segments from `first` on that one rung has.
std::vector<double> count_readings(const Ladder& ladder, const Rung& rung, const ShootingProblem& problem,
                                   std::size_t first) {
  std::vector<double> counts(ladder.channels.size(), 0.0);
  for (std::size_t k = first; k < first + rung.segments.size(); ++k)
    for (std::size_t r = 0; r < problem.segments()[k].rows.size(); ++r)
      counts[problem.place(k, static_cast<Eigen::Index>(r)).channel] += 1.0;
  return counts;
}

/// Row weights under which least squares descends the cost: √(w/(N·max(m, floor))), times the channel's scale. All are
/// multiplied by √N of the channel with most readings, against which the priors of starts are weighed; gives 1/N.
double set_weights(const Ladder& ladder, const ShootingProblem& problem, const HorizonErrors& errors,
                   const std::vector<Eigen::VectorXd>& residuals, std::vector<Eigen::VectorXd>& weights) {
  std::size_t first = 0;
  double most = 0.0;
  for (std::size_t rung = 0; rung < ladder.rungs.size(); ++rung) {
    const std::vector<double> counts = count_readings(ladder, ladder.rungs[rung], problem, first);
    most = std::max(most, *std::max_element(counts.begin(), counts.end()));
    const std::size_t end = first + ladder.rungs[rung].segments.size();
    for (std::size_t k = first; k < end; ++k)
      for (Eigen::Index row = 0; row < weights[k].size(); ++row) {
        const std::size_t c = problem.place(k, row).channel;
        const double mean = errors.mean_square[rung][c], floor = ladder.rungs[rung].floor[c];
        const double far = mean > 0.0 ? std::abs(residuals[k](row)) / std::sqrt(mean) : 0.0;
        const double down = far > kWinsorRow ? kWinsorRow / far : 1.0;
        const double weight = errors.weight[rung][c] / (std::max(1.0, counts[c]) * std::max(mean, floor));
        weights[k](row) = std::max(kLeastWeight, problem.scales()[c] * down * std::sqrt(weight));
      }
    first = end;
  }
  for (Eigen::VectorXd& of_segment : weights) of_segment *= std::sqrt(most);
  return 1.0 / most;
}

/// Rounds of least squares on one ladder, from `values`; the best is left in `fit`.
void descend(const Ladder& ladder, const TrialPredictor& predictor, const ParameterSpace& space, int rounds,
             HorizonFit& fit) {
  ShootingProblem problem(predictor, space, all_segments(ladder), ladder.channels);
  WeightedProblem weighted(problem);
  FitPoint point = problem.start(space.clamp(space.to_coordinates(fit.values)));
  std::vector<Eigen::VectorXd> residuals;
  const auto judge = [&](const FitPoint& at) {
    if (!problem.residuals(at, residuals)) return HorizonErrors{};
    residuals = in_units(problem, std::move(residuals));
    return horizon_errors(ladder, predictor.trials(), residuals);
  };
  const auto keep = [&](const HorizonErrors& errors) {
    fit.errors = errors;
    fit.states = point.states;
    fit.residuals = residuals;
  };
  keep(judge(point));
  for (int round = 0; fit.errors.valid && round < rounds; ++round) {
    fit.prior_weight = set_weights(ladder, problem, fit.errors, residuals, weighted.weights());
    LeastSquaresOptions options;
    options.max_iterations = kStepsARound;
    options.tolerance = 1e-3;
    const LeastSquaresResult found = minimize(weighted, point, options);
    fit.iterations += found.iterations;
    if (!found.valid) break;
    const HorizonErrors now = judge(found.point);
    if (!now.valid || now.cost > fit.errors.cost) break;
    const double gained = fit.errors.cost - now.cost;
    point = found.point;
    keep(now);
    if (gained < kTolerance) break;
  }
  fit.values = space.to_values(point.values);
  fit.simulations += problem.simulations();
}

}  // namespace

HorizonFit fit_to_ladder(const Ladder& ladder, const TrialPredictor& predictor, const ParameterSpace& space,
                         const std::vector<double>& start, Climb climb) {
  HorizonFit fit;
  fit.values = start;
  for (std::size_t rungs = 1; climb == Climb::from_the_bottom && rungs < ladder.rungs.size(); ++rungs)
    descend(first_rungs(ladder, rungs), predictor, space, kRoundsOnTheWay, fit);
  descend(ladder, predictor, space, climb == Climb::polish ? 1 : kMostRounds, fit);
  return fit;
}

HorizonErrors errors_on(const Ladder& ladder, const TrialPredictor& predictor, const ParameterSpace& space,
                        const std::vector<double>& values) {
  ShootingProblem problem(predictor, space, all_segments(ladder), ladder.channels);
  std::vector<Eigen::VectorXd> residuals;
  if (!problem.residuals(problem.start(space.clamp(space.to_coordinates(values))), residuals)) return {};
  return horizon_errors(ladder, predictor.trials(), in_units(problem, std::move(residuals)));
}

}  // namespace lacuna
