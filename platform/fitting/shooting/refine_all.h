#pragma once

#include "fitting/numerics/progress_meter.h"
#include "fitting/shooting/refinement.h"

#include <string>
#include <vector>

namespace lacuna {

/// Refines every start on a copy of `problem`, so that neither threads nor the other starts change a digit. Searches
/// run one after the other, each with all threads; with more threads than one search can use at a time, as many run
/// side by side as keep them busy. Counts go into `problem`. Results are in the order of the starts; `what` names them
/// to the meter, one part each.
std::vector<Candidate> refine_all(ShootingProblem& problem, const std::vector<Eigen::VectorXd>& starts,
                                  const RefinementOptions& options, ProgressMeter& meter, const std::string& what);

}  // namespace lacuna
