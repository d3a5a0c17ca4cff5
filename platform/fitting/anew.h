#pragma once

#include "fitting/fit.h"
#include "fitting/numerics/progress_meter.h"
#include "fitting/shooting/refinement.h"

#include <string>
#include <vector>

namespace lacuna {

/// The last stage of a fit, which retries starts that earlier stages may have led away from.
struct AnewTask {
  const FitTask& fit;
  const ParameterSpace& space;
  const RobustLoss& loss;
  ShootingProblem& problem;
  ProgressMeter& meter;
  const std::string& stage;  ///< its name
};

/// Where a model lacks something, short segments may lead far away from the values that predict whole trials best.
/// Tries all starting points; adds those that are better than the best of `candidates`. Returns how many were tried.
int try_all_starts(const AnewTask& task, std::vector<Candidate>& candidates);

/// Short segments, or a base with a large error, may also lead away from known values of an effect, such as those found
/// by a diagnosis. Where they did, tries the effect's start values of the experiment with the values of all else that
/// fit best beside them, because fitted values may have absorbed the effect. Otherwise like `try_all_starts`.
int try_known_starts(const AnewTask& task, std::vector<Candidate>& candidates);

}  // namespace lacuna
