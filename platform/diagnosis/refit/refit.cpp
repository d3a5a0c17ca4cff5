#include "diagnosis/refit/refit.h"

#include "diagnosis/refit/timing.h"

#include <Eigen/Cholesky>

#include <cmath>
#include <limits>
#include <optional>

namespace lacuna {
namespace {

/// Of free runs through contacts, where the deviance is no smoother: impacts happen at whole steps.
constexpr int kMostRunIterations = 10;
constexpr double kRunPrecision = 0.5;
constexpr double kWidest = 1e12;  ///< range of coordinates without bounds

/// Where the data leave a direction open, its variance is that of values anywhere within their bounds: a pseudo-inverse
/// would call such values certain.
Eigen::MatrixXd inverse_within(const Eigen::MatrixXd& information, const Eigen::VectorXd& ranges) {
  const Eigen::VectorXd deviations = ranges / std::sqrt(12.0);
  Eigen::MatrixXd relative = deviations.asDiagonal() * information * deviations.asDiagonal();
  relative.diagonal().array() += 1.0;
  const Eigen::MatrixXd inverse =
      relative.llt().solve(Eigen::MatrixXd::Identity(information.rows(), information.cols()));
  return deviations.asDiagonal() * inverse * deviations.asDiagonal();
}

void describe_solution(WhitenedProblem& problem, const RowBins& rows, const std::vector<Eigen::MatrixXd>& factors,
                       LeastSquaresResult& search, Refit& result) {
  std::vector<SegmentJacobian>& jacobians = search.jacobians;
  if (jacobians.empty()) problem.linearize(search.point, search.residuals, jacobians);
  const Eigen::Index count = search.point.values.size();
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(count, count);
  for (std::size_t k = 0; k < jacobians.size(); ++k) {
    const Eigen::Index bins = problem.robust_rows(k);
    const RobustSegment segment{search.residuals[k], jacobians[k].values, jacobians[k].state, rows.blocks(k),
                                problem.priors_of_values()};
    WeightedSegment under_weights = weighted(segment, segment.weights(segment.residual));
    result.bin_residuals.emplace_back(factors[k] * segment.residual.head(bins));
    result.bin_derivatives.emplace_back(
        factors[k] * (segment.values.topRows(bins) + segment.state.topRows(bins) * under_weights.start_follows));
    information += under_weights.values.transpose() * under_weights.values;
    result.segments.push_back(segment);
    result.weighted.push_back(std::move(under_weights));
  }
  const double near = 1e-9;
  std::vector<Eigen::Index> inside;
  for (Eigen::Index j = 0; j < count; ++j) {
    const double range = problem.upper()(j) - problem.lower()(j), at = search.point.values(j);
    result.at_bound.push_back(at <= problem.lower()(j) + near * range || at >= problem.upper()(j) - near * range);
    if (!result.at_bound.back()) inside.push_back(j);
  }
  result.covariance = Eigen::MatrixXd::Zero(count, count);
  if (inside.empty()) return;
  Eigen::VectorXd ranges = (problem.upper() - problem.lower()).cwiseMin(kWidest);
  ranges.tail(problem.priors_of_values()).setConstant(kWidest);  // rows say what is known of these
  result.covariance(inside, inside) = inverse_within(information(inside, inside), ranges(inside));
}

/// Difference steps that the base has found, where the model has the base's values and states.
std::vector<double> known_steps(const RefittedModel& refitted, const BaseSolution& base, std::vector<double> steps) {
  const std::size_t values = base.values.size(), states = base.steps.size() - values;
  for (std::size_t i = 0; i < values; ++i) steps[refitted.base[i]] = base.steps[i];
  for (std::size_t i = 0; i < states; ++i) steps[steps.size() - states + i] = base.steps[values + i];
  return steps;
}

/// The start with the least cost; nothing where none can be simulated.
std::optional<FitPoint> best_start(WhitenedProblem& problem, const ParameterSpace& space, const BaseSolution& base,
                                   const std::vector<std::vector<double>>& starts) {
  std::optional<FitPoint> best;
  double least = std::numeric_limits<double>::infinity();
  std::vector<Eigen::VectorXd> residuals;
  for (const std::vector<double>& start : starts) {
    std::vector<double> values = start;
    if (base.timing) values.push_back(*base.timing);
    const FitPoint point{space.to_coordinates(values), base.states};
    if (!problem.residuals(point, residuals)) continue;
    const double cost = total_cost(problem, residuals, kBinLoss);
    if (!(cost < least)) continue;
    least = cost;
    best = point;
  }
  return best;
}

}  // namespace

BaseSolution from(BaseSolution base, const Refit& fit) {
  base.states = fit.states;
  base.timing = fit.timing;
  return base;
}

Refit refit(const RefittedModel& refitted, const BaseSolution& base, const RowBins& bins,
            const std::vector<Eigen::MatrixXd>& factors, const std::vector<std::vector<double>>& starts, int threads,
            RefitEffort effort) {
  const Timing timing = base.timing ? Timing::fitted : Timing::as_recorded;
  const TrialPredictor predictor(refitted.model, base.trials, threads, timing);
  const ParameterSpace space(base.timing ? with_timing(refitted.definition.free) : refitted.definition.free);
  ShootingProblem shooting(predictor, space, base.segments, base.noise);
  shooting.set_steps(known_steps(refitted, base, shooting.steps()));
  WhitenedProblem problem(shooting, bins, factors, timing);
  if (base.free_run) {
    effort.iterations = std::min(effort.iterations, kMostRunIterations);
    effort.precision = std::max(effort.precision, kRunPrecision);
  }
  LeastSquaresOptions options{
      .loss = kBinLoss, .max_iterations = effort.iterations, .tolerance = 0.0, .progress = {}, .secants = true};
  options.tolerance = effort.precision / static_cast<double>(bins.rows());
  const std::optional<FitPoint> start = best_start(problem, space, base, starts);
  Refit best;
  if (!start) return best;
  LeastSquaresResult solution = minimize(problem, *start, options);
  best.valid = solution.valid;
  best.converged = solution.converged;
  best.deviance = solution.cost;
  if (!best.valid) return best;
  best.values = space.to_values(solution.point.values);
  if (base.timing) {
    best.timing = best.values.back();
    best.values.pop_back();
  }
  best.states = solution.point.states;
  describe_solution(problem, bins, factors, solution, best);
  return best;
}

}  // namespace lacuna
