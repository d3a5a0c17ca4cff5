#include "diagnosis/base_bench.h"

#include <utility>

namespace lacuna {

namespace {

constexpr int kIterations = 10, kStartIterations = 4;
constexpr int kFirstIterations = 2;                     ///< after which values that have far to go have begun to
constexpr double kFarBetter = 0.5, kBeginsToBe = 0.75;  ///< of what is left over

/// A problem whose values are held where they are: of its unknowns the states alone are left.
class HeldValues : public SegmentedProblem {
 public:
  HeldValues(ShootingProblem& problem, Eigen::VectorXd values) : problem_(problem), values_(std::move(values)) {}

  const Eigen::VectorXd& lower() const override { return none_; }
  const Eigen::VectorXd& upper() const override { return none_; }
  Eigen::Index robust_rows(std::size_t k) const override { return problem_.robust_rows(k); }
  bool residuals(const FitPoint& point, std::vector<Eigen::VectorXd>& residuals) override {
    return problem_.residuals({values_, point.states}, residuals);
  }
  void linearize(const FitPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                 std::vector<SegmentJacobian>& jacobians) override {
    problem_.linearize_states({values_, point.states}, residuals, jacobians);
  }

 private:
  ShootingProblem& problem_;
  const Eigen::VectorXd values_, none_;
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
  const Eigen::VectorXd values = space.clamp(space.to_coordinates(base.values));
  HeldValues held(problem, values);
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
      rough_(contender.definition, start, threads),
      space_(contender.definition.free),
      problem_(predictor_, space_, start.segments, start.noise) {
  problem_.difference_by(rough_.predictor());
}

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
