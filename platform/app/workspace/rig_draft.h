#pragma once

#include "config/schema/blank.h"
#include "measurement/guesses/file_sample.h"
#include "measurement/recording.h"
#include "measurement/rig_guess.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// Everything that `lacuna new` knows before it writes.
struct RigDraft {
  RigGuess guess;
  std::filesystem::path experiment;      ///< to be written
  std::filesystem::path robot;           ///< to be written, or there already
  std::optional<RobotSpec> known_robot;  ///< of a file that is there; none: it is drafted too
  std::optional<ActuatorKind> drive;     ///< what all actuators take by what was logged; none: what the file says
  std::vector<GuessedFile> files;
  std::optional<FileSample> first_file;  ///< the beginning of the first of them
  std::optional<Recording> recording;    ///< as read with the guess; none where the files have problems
  double interval = 0.0;                 ///< s, median; 0: not known
  double shortest = 0.0;                 ///< s, of the recordings; 0: not known
};

/// The name that the experiment and its robot get: the file's, with what cannot be in a name left out.
std::string rig_name(const std::filesystem::path& experiment);

/// The experiment file, commented; what is guessed says so.
std::string experiment_text(const RigDraft& draft);

/// The robot stub: a body and a joint for each guessed joint, with its motor and sensors. What no
/// recording tells (masses, inertias, where things are) is blank.
std::string robot_text(const RigDraft& draft);

/// What there is to say of a sensor or an actuator without a column, half a sentence.
std::string reason_of(const UnmatchedChannel& left);

/// The known robot, or the stub's as `placeholder_robot` makes it.
RobotSpec robot_of(const RigDraft& draft);

/// The robot of the stub with blanks left at their defaults, to read the recordings with.
RobotSpec placeholder_robot(const RigGuess& guess);

/// A step for the engine: the sampling interval, or the largest part of it that is at most 10 ms. Without one, 1 ms.
double step_for(double interval);

}  // namespace lacuna
