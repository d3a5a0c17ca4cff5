#include "diagnosis/rounds/base_bench.h"

#include "fitting/states_problem.h"

#include <utility>

namespace lacuna {

namespace {

constexpr int kIterations = 10, kStartIterations = 4;
constexpr int kFirstIterations = 2;                     ///< after which values that have far to go have begun to
constexpr double kFarBetter = 0.5, kBeginsToBe = 0.75;  ///< of what is left over

LeastSquaresOptions options_of(int iterations) {
  LeastSquaresOptions options;
  options.loss = {3.0};
  options.max_iterations = iterations;
  options.tolerance = 1e-4;
  return options;
}

}  // namespace

bool settle(ShootingProblem& problem, const ParameterSpace& space, BaseSolution& base, Moving moving) {
  const Eigen::VectorXd values = space.clamp(space.to_coordinates(base.values));
  StatesProblem held(problem, values);
  const LeastSquaresResult started = minimize(held, {Eigen::VectorXd(), base.states}, options_of(kStartIterations));
  if (!started.valid) return false;
  FitPoint point{values, started.point.states};
  const bool all = moving == Moving::all;
  LeastSquaresResult search = minimize(problem, point, options_of(all ? kIterations : kFirstIterations));
  if (!all && search.cost <= kBeginsToBe * started.cost)
    search = minimize(problem, search.point, options_of(kIterations - kFirstIterations));
  if (all || search.cost <= kFarBetter * started.cost) point = search.point;
  base.values = space.to_values(point.values);
  base.states = point.states;
  return true;
}

BaseBench::BaseBench(const Contender& contender, const BaseSolution& start, int threads)
    : predictor_(*contender.model, start.trials, threads),
      space_(contender.definition.free),
      problem_(predictor_, space_, start.segments, start.noise) {}

void BaseBench::settle(BaseSolution& base, Moving moving) {
  if (!lacuna::settle(problem_, space_, base, moving))
    throw Error("the fitted model cannot be simulated: " + problem_.last_reason());
}

void BaseBench::linearise(const RowBins& bins, BaseSolution& base) {
  const FitPoint here = point(base);
  std::vector<Eigen::VectorXd> residuals;
  if (!problem_.residuals(here, residuals))
    throw Error("the fitted model cannot be simulated: " + problem_.last_reason());
  base.linear = linear_segments(problem_, bins, here, residuals);
  base.residual = rms(base.linear);
  base.steps = problem_.steps();
}

}  // namespace lacuna
