#pragma once

#include "prediction/smoothed_starts.h"

#include <vector>

namespace lacuna {

/// Where a prediction of a model begins that changes what sensors read.
struct ReadStart {
  const SmoothedStarts& starts;
  const TrialPredictor& predictor;
  const Stretch& stretch;
  const std::vector<double>& values;  ///< of the model
  const WarmUp* warm_up;
  int worker;
};

/// Where a prediction begins, and what is simulated before it.
struct ChangedStart {
  StartState start;
  std::optional<WarmUp> warm_up;
  bool reads_backwards = false;  ///< a reading falls where what it reads rises: no sensor does that
};

/// The start from which the model's first readings are what plain sensors would read at `start`: of a sensor that is
/// off by 0.1 rad the joint stands 0.1 rad further. What a sensor that is late by 10 ms reads first happened 10 ms
/// before: from half a sample on its coordinate begins there, in the warm-up, so that it is predicted over as long a
/// time as any other; its start is NaN then. Below, and without a warm-up, it begins where its readings are 10 ms
/// later. Velocities follow the slope of the reading. A coordinate whose reading does not follow it (of a saturated
/// sensor) stays. `prediction` is used for the simulations.
ChangedStart start_by_readings(const ReadStart& read, const StartState& start, Prediction& prediction);

}  // namespace lacuna
