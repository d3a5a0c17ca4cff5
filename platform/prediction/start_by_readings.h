#pragma once

#include "prediction/smoothed_starts.h"

#include <vector>

namespace lacuna {

/// The initial state of a prediction for a model that changes sensor readings.
struct ReadStart {
  const SmoothedStarts& starts;
  const TrialPredictor& predictor;
  const Stretch& stretch;
  const std::vector<double>& values;  ///< of the model
  const WarmUp* warm_up;
  int worker;
};

/// The start of a prediction, and the warm-up that is simulated before it.
struct ChangedStart {
  StartState start;
  std::optional<WarmUp> warm_up;
  bool reads_backwards = false;  ///< a reading falls where the measured coordinate rises, as with no real sensor
};

/// The start at which the model's first readings equal those of ideal sensors at `start`: with a sensor offset of 0.1
/// rad the joint stands 0.1 rad before it. The first reading of a sensor with a delay of 10 ms shows the state 10 ms
/// earlier. For delays from half a sample on, the coordinate begins there, in the warm-up, so that it is predicted over
/// as long a time as any other; its value at the start is then NaN. For smaller delays, and without a warm-up, it
/// begins at its readings of 10 ms later. Velocities follow the slope of the reading. A coordinate whose reading does
/// not follow it (saturated sensor) stays. `prediction` runs the simulations.
ChangedStart start_by_readings(const ReadStart& read, const StartState& start, Prediction& prediction);

}  // namespace lacuna
