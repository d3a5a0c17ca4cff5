#pragma once

#include "baselines/answer.h"

namespace hidden_effects {

/// Grouped stepwise regression on inverse dynamics, as robots' parameters are commonly identified (M. Gautier,
/// Proc. IEEE ICRA 1997, 1060-1065): readings smoothed without delay and differentiated, the balance of torques
/// that the fitted base leaves, in units of acceleration, regressed on what its free values and an effect's parameters
/// do to it. Effects enter as groups, one after the other, while the extended Bayesian criterion falls (J. Chen, Z.
/// Chen, Biometrika 95 (2008) 759-771); each with the best of several shapes, a shape counting as the parameters
/// that make it. Scores are half of the criterion's fall, in nats: as it entered for those that are chosen, alone for
/// the others behind them.
///
/// What acts between motion and readings, or on a rotor that nobody reads, is in no such balance: the effects of
/// sensors, joint_compliance and backlash are last in its ranking.
BaselineAnswer by_stepwise_regression(const Observed& seen, const RecordedMotions& motions,
                                      const std::vector<Candidate>& candidates);

}  // namespace hidden_effects
