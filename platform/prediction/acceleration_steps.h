#pragma once

#include "prediction/prediction_ladder.h"

#include <lacuna/engine_settings.h>

#include <vector>

namespace lacuna {

/// Predictions of a single integration step from smoothed states, compared with the smoothed accelerations. As with
/// inverse dynamics, the forces of a model enter linearly and no error grows, so a fit to these steps finds its way
/// from anywhere. Accelerations are smoothed and not measured: what is found is a start for a fit to the readings.
struct AccelerationSteps {
  EngineSettings engine;      ///< those of the search with steps of a sixteenth of the readings' interval, or shorter
  std::vector<Trial> trials;  ///< pairs of samples one step apart, with the readings of the smoothed motion
  PredictionLadder ladder;    ///< of one length; its trials are these, its starts are exact
  bool empty() const { return ladder.stretches.empty(); }
};

/// Of `most` samples at the most, evenly spread over the trials that are fitted. None where a sample of a trial cannot
/// be a start. `engine`: settings of the search.
AccelerationSteps acceleration_steps(const LadderSource& source, const EngineSettings& engine, std::size_t most);

}  // namespace lacuna
