#pragma once

#include "cases/make_case.h"
#include "oracle/linear_trial.h"

namespace hidden_effects {

/// Whitens by the true covariance of a case's noise: the innovations of a Kalman filter (B. D. O. Anderson, J. B.
/// Moore, Optimal Filtering, Prentice-Hall 1979, chapter 9) over each trial's differences, divided by their deviations.
/// What the filter knows: white noise of each sensor, and of its quantum (quantum²/12); a slow one; slow random forces
/// on the joints and noise on the recorded commands, both through the plant linearised along its true motion. Where a
/// trial starts counts as known: starts are fitted apart. `trials` in the order in which the fit has them.
Whiten kalman_whitener(const PlantModel& truth, const Eigen::VectorXd& values, const std::vector<TrueTrial>& trials,
                       const CaseNoise& noise, double step = kFitStep);

}  // namespace hidden_effects
