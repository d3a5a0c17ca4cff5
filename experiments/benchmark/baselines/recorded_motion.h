#pragma once

#include "baselines/observed.h"

namespace hidden_effects {

/// How the joints moved in a trial as far as readings tell, one number a sample. Joints whose position nobody measures
/// are said to stand still.
struct RecordedMotion {
  std::vector<std::vector<double>> position, velocity, acceleration;  ///< by joint, rad or m
};

struct RecordedMotions {
  std::vector<RecordedMotion> trials;
  double cutoff = 0.0;  ///< Hz, up to where positions stand out of their noise
};

/// Central differences of readings that are smoothed without delay, at three times the cutoff: what is computed of them
/// is to be smoothed at the cutoff itself, and should not be smoothed there twice.
RecordedMotions recorded_motions(const Observed& seen);

/// How large things are at a place, by the recordings alone.
Scales recorded_scales(const Observed& seen, const RecordedMotions& motions, Place place, int element);

}  // namespace hidden_effects
