#pragma once

#include <lacuna/robot_spec.h>
#include <lacuna/time_series.h>

#include "measurement/guesses/column_guess.h"

#include <string>
#include <vector>

namespace lacuna {

/// A column with its sensor channel or actuator.
struct MatchedColumn {
  Channel channel;
  GuessedColumn column;
};

/// A sensor channel or an actuator of a robot without a column.
struct UnmatchedChannel {
  Channel channel;
  bool is_actuator = false;
  std::vector<std::string> candidates;  ///< columns that fit equally well; empty: none fits
};

struct RobotMatch {
  std::vector<MatchedColumn> sensors, commands;  ///< in the robot's order
  std::vector<UnmatchedChannel> unmatched;
  std::vector<GuessedColumn> unused;
};

/// Matches columns with the sensor channels and the actuators of a robot: first those of one name, then those that
/// share most words with the name of the channel or of its joint, then those that are the only ones of their unit or as
/// many as the channels of that unit. Ambiguous ones stay unmatched. A unit of another dimension excludes a sensor; an
/// actuator takes any command, because a gain may convert it.
RobotMatch match_robot(const RobotSpec& robot, const std::vector<GuessedColumn>& columns);

}  // namespace lacuna
