#pragma once

#include "fitting/start_states.h"

#include <vector>

namespace lacuna {

/// Where a prediction of a model begins that changes what sensors read.
struct ReadStart {
  const StartStates& states;  ///< which channel reads which coordinate, without the model's changes
  const TrialPredictor& predictor;
  const Stretch& stretch;
  const std::vector<double>& values;  ///< of the model
  const WarmUp* warm_up;
  int worker;
};

/// The start from which the model's first readings are what plain sensors would read at `start`: of a sensor that is
/// off by 0.1 rad the joint stands 0.1 rad further. Velocities follow the slope of the reading. A coordinate whose
/// reading does not follow it (a saturated or late sensor) keeps its velocity. `prediction` is used for the
/// simulations.
StartState start_by_readings(const ReadStart& read, const StartState& start, Prediction& prediction);

}  // namespace lacuna
