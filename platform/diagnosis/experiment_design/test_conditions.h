#pragma once

#include "diagnosis/rounds/round.h"

#include <vector>

namespace lacuna {

/// How one more trial would begin and be read if it is made as those before it were.
struct TestConditions {
  StartState start;  ///< of the first trial, as its first readings tell it
  /// Of the joint coordinates, positions and then velocities (m or rad, and per second), as wide as a diagnosis takes
  /// them: `kDoubtOfStart` times what the first readings leave open. 0 where the trials state it exactly, and where no
  /// reading tells it.
  std::vector<double> start_deviation;
  /// By channel: deviations of single readings, independent of each other, that tell as little of slow changes as the
  /// noise of the round does, slow noise and random forces included.
  std::vector<ChannelNoise> noise;
};

/// `period`: s, between readings.
TestConditions like_the_trials(const Round& round, double period);

}  // namespace lacuna
