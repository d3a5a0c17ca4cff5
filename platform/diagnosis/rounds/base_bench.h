#pragma once

#include "diagnosis/candidates/contender.h"
#include "diagnosis/noise/base_solution.h"

namespace lacuna {

enum class Moving { if_needed, all };

/// Least squares under sensor noise alone, to begin with: moves states, then values and states. False where the model
/// cannot be simulated. `if_needed`: for values that were fitted under a better noise, which stay where they are unless
/// others leave half as much.
bool settle(ShootingProblem& problem, const ParameterSpace& space, BaseSolution& base, Moving moving);

/// A round's model at its base solution, ready to be simulated. Trials and segments of `start` are copied; its noise
/// and `contender` must live as long as the bench.
class BaseBench {
 public:
  BaseBench(const Contender& contender, const BaseSolution& start, int threads);
  BaseBench(const BaseBench&) = delete;
  BaseBench& operator=(const BaseBench&) = delete;

  /// As above, but throws `Error` where the model cannot be simulated.
  void settle(BaseSolution& base, Moving moving);
  /// Residual and derivatives at the base's values and states. Throws like `settle`.
  void linearise(const RowBins& bins, BaseSolution& base);

  const TrialPredictor& predictor() const { return predictor_; }
  ShootingProblem& problem() { return problem_; }
  FitPoint point(const BaseSolution& base) const { return {space_.to_coordinates(base.values), base.states}; }

 private:
  TrialPredictor predictor_;
  ParameterSpace space_;
  ShootingProblem problem_;
};

}  // namespace lacuna
