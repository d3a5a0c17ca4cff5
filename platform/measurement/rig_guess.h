#pragma once

#include <lacuna/robot_spec.h>

#include "foundation/recording_source.h"
#include "measurement/guesses/robot_match.h"

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// A joint that some columns seem to belong to.
struct GuessedJoint {
  std::string name;     ///< "hinge", "slider", or from the columns: "elbow", "joint1"
  bool slides = false;  ///< else it turns
  std::optional<GuessedColumn> position, velocity;
  std::optional<GuessedColumn> command;
  ActuatorKind actuator = ActuatorKind::force;  ///< a servo where the command is a reference, voltage where it is one
  bool only_one = true;                         ///< then names need not tell joints apart

  /// Names of what stands around it in the robot.
  std::string body() const;
  std::string motor() const;
  std::string position_sensor() const;
  std::string velocity_sensor() const;
};

/// What recordings seem to be of.
struct RigGuess {
  GuessedColumn time;
  std::string time_unit_reason;
  std::optional<GuessedColumn> trial;
  Hold hold = Hold::zero_order;
  std::string hold_reason;
  std::vector<GuessedJoint> joints;              ///< none where the robot was known
  std::vector<MatchedColumn> sensors, commands;  ///< of the joints, or of the known robot
  std::vector<UnmatchedChannel> unmatched;       ///< of the known robot
  std::vector<GuessedColumn> unused;
};

/// Puts the columns that all files have together to joints. Throws `BadInput` for files that are not
/// readable, and `Error` where no column can be the time or none is measured, saying how to name them.
RigGuess guess_rig(const std::vector<FileSample>& samples, const ColumnHints& hints);

/// The same for a robot that is known: the columns that all files have are matched with its sensors and actuators.
/// Throws `Error` where no sensor gets one.
RigGuess guess_rig(const std::vector<FileSample>& samples, const ColumnHints& hints, const RobotSpec& robot);

/// A recording that a guess is made from: a file, or one of the runs in it (csv_runs.h).
struct GuessedFile {
  std::filesystem::path path;
  std::string run = {};
};

/// A source that reads the files as guessed; units that are not known are taken to be SI, and gains 1.
RecordingSource source_of(const RigGuess& guess, const std::vector<GuessedFile>& files);

/// SI unit of what a joint's position, velocity or actuator has.
std::string position_unit(const GuessedJoint& joint);
std::string velocity_unit(const GuessedJoint& joint);
std::string command_unit(const GuessedJoint& joint);

}  // namespace lacuna
