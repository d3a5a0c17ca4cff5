#pragma once

#include <lacuna/trial.h>

#include "fitting/floor/noise_floor.h"

#include <vector>

namespace lacuna {

/// How one more trial would begin and be read under the same conditions as the trials so far.
struct TestConditions {
  StartState start;  ///< start of the first trial, estimated from its first readings
  /// Of the joint coordinates, positions and then velocities (m or rad, and per second). 0 where the trials state it
  /// exactly, and where no reading tells it.
  std::vector<double> start_deviation;
  std::vector<ChannelNoise> noise;  ///< by channel: standard deviations of single independent readings
};

}  // namespace lacuna
