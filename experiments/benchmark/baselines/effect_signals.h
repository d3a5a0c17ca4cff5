#pragma once

#include "baselines/base_fit.h"
#include "baselines/candidate.h"

namespace hidden_effects {

/// What a candidate, switched on at some parameters, changes in the fitted base's whitened prediction.
struct EffectSignal {
  std::size_t candidate = 0;
  Try tried;
  Eigen::VectorXd change;    ///< all trials; empty where the plant ran away
  double correlation = 0.0;  ///< with the base's residual, −1 to 1
  double partial = 0.0;      ///< the same after what the base's values and starts can do is projected out of both
  double scale = 0.0;        ///< times the change, so projected, comes closest to the residual
};

/// One or more for each candidate, `tries` at most.
std::vector<EffectSignal> effect_signals(const Observed& seen, const BaseFit& base,
                                         const std::vector<Candidate>& candidates, std::size_t tries);

}  // namespace hidden_effects
