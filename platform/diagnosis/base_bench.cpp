#include "diagnosis/base_bench.h"

namespace lacuna {

BaseBench::BaseBench(const Contender& contender, const BaseSolution& start, int threads)
    : predictor_(*contender.model, start.trials, threads),
      space_(contender.definition.free),
      problem_(predictor_, space_, start.segments, start.noise) {}

void BaseBench::settle(BaseSolution& base) {
  const FitPoint start{space_.clamp(space_.to_coordinates(base.values)), base.states};
  LeastSquaresOptions options;
  options.loss = {3.0};
  options.max_iterations = 10;
  options.tolerance = 1e-4;
  const LeastSquaresResult search = minimize(problem_, start, options);
  if (!search.valid) throw Error("the fitted model cannot be simulated: " + problem_.last_reason());
  base.values = space_.to_values(search.point.values);
  base.states = search.point.states;
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
