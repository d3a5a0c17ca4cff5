#pragma once

#include <lacuna/trial.h>

namespace lacuna {

/// A trial with the data for repeating it on a model.
struct ScoredTrial {
  Test test;  ///< closed loop: the controller that was used; otherwise the commands
  Trial trial;
  Eigen::Index first_sample = 0;  ///< the samples before it are not scored
};

}  // namespace lacuna
