#include "diagnosis/base_bench.h"

#include <utility>

namespace lacuna {

namespace {

constexpr int kIterations = 10, kStartIterations = 4;
constexpr double kFarBetter = 0.5;  ///< of what is left over

/// A problem whose values are held where they are.
class HeldValues : public SegmentedProblem {
 public:
  HeldValues(SegmentedProblem& problem, Eigen::VectorXd values) : problem_(problem), values_(std::move(values)) {}

  const Eigen::VectorXd& lower() const override { return values_; }
  const Eigen::VectorXd& upper() const override { return values_; }
  Eigen::Index robust_rows(std::size_t k) const override { return problem_.robust_rows(k); }
  bool residuals(const FitPoint& point, std::vector<Eigen::VectorXd>& residuals) override {
    return problem_.residuals(point, residuals);
  }
  void linearize(const FitPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                 std::vector<SegmentJacobian>& jacobians) override {
    problem_.linearize(point, residuals, jacobians);
  }

 private:
  SegmentedProblem& problem_;
  Eigen::VectorXd values_;
};

LeastSquaresOptions options_of(int iterations) {
  LeastSquaresOptions options;
  options.loss = {3.0};
  options.max_iterations = iterations;
  options.tolerance = 1e-4;
  return options;
}

}  // namespace

bool settle(ShootingProblem& problem, const ParameterSpace& space, BaseSolution& base, Moving moving) {
  const FitPoint start{space.clamp(space.to_coordinates(base.values)), base.states};
  HeldValues held(problem, start.values);
  const LeastSquaresResult started = minimize(held, start, options_of(kStartIterations));
  if (!started.valid) return false;
  LeastSquaresResult search = minimize(problem, started.point, options_of(kIterations));
  if (moving == Moving::if_needed && search.cost > kFarBetter * started.cost) search = started;
  base.values = space.to_values(search.point.values);
  base.states = search.point.states;
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
