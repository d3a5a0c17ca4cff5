#pragma once

#include "fitting/fit.h"
#include "fitting/numerics/progress_meter.h"
#include "fitting/shooting/refinement.h"

#include <string>
#include <vector>

namespace lacuna {

/// The last stage of a fit, where it tries what the stages before may have led away from.
struct AnewTask {
  const FitTask& fit;
  const ParameterSpace& space;
  const RobustLoss& loss;
  ShootingProblem& problem;
  ProgressMeter& meter;
  const std::string& stage;  ///< its name
};

/// Where a model lacks something, short segments may lead far away from the values that predict whole trials best.
/// Tries all starting points; what is better than the best of `candidates` joins them. Returns how many were tried.
int try_all_starts(const AnewTask& task, std::vector<Candidate>& candidates);

/// Short segments, or a base that is far off, may also lead away from what is known of an effect, such as what a
/// diagnosis found. Where they did, tries the values that the experiment gives it, beside those of all else that fit
/// best with them: what was found may have given these what the effect does. As `try_all_starts` otherwise.
int try_known_starts(const AnewTask& task, std::vector<Candidate>& candidates);

}  // namespace lacuna
