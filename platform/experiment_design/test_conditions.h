#pragma once

#include <lacuna/trial.h>

#include "fitting/floor/noise_floor.h"

#include <vector>

namespace lacuna {

/// How one more trial would begin and be read if it is made as those before it were.
struct TestConditions {
  StartState start;  ///< of the first trial, as its first readings tell it
  /// Of the joint coordinates, positions and then velocities (m or rad, and per second). 0 where the trials state it
  /// exactly, and where no reading tells it.
  std::vector<double> start_deviation;
  std::vector<ChannelNoise> noise;  ///< by channel: deviations of single readings, independent of each other
};

}  // namespace lacuna
