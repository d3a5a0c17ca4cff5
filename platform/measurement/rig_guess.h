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
  ActuatorKind actuator = ActuatorKind::force;  ///< a servo if the command is a reference, a voltage if it is one
  bool only_one = true;                         ///< then names need not distinguish joints

  /// Names of the elements around it in the robot.
  std::string body() const;
  std::string motor() const;
  std::string position_sensor() const;
  std::string velocity_sensor() const;
};

/// A guess at the rig of some recordings.
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

/// Assigns the columns that all files have to joints. Throws `BadInput` for files that are not readable, and `Error`
/// where no column can be the time or none is measured, with how to name them.
RigGuess guess_rig(const std::vector<FileSample>& samples, const ColumnHints& hints);

/// The same for a known robot: the columns that all files have are matched with its sensors and actuators. Throws
/// `Error` where no sensor gets one.
RigGuess guess_rig(const std::vector<FileSample>& samples, const ColumnHints& hints, const RobotSpec& robot);

/// A recording for a guess: a file, or one of the runs in it (csv_runs.h).
struct GuessedFile {
  std::filesystem::path path;
  std::string run = {};
};

/// A source that reads the files as guessed; unknown units are assumed to be SI, and gains 1.
RecordingSource source_of(const RigGuess& guess, const std::vector<GuessedFile>& files);

/// SI unit of a joint's position, velocity or actuator.
std::string position_unit(const GuessedJoint& joint);
std::string velocity_unit(const GuessedJoint& joint);
std::string command_unit(const GuessedJoint& joint);

}  // namespace lacuna
