#pragma once

#include <lacuna/setup.h>
#include <lacuna/trial.h>

#include "foundation/text/encoding.h"
#include "foundation/text/problem.h"

#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lacuna {

/// Settings for reading measured files: `[target]` of kind "recorded".

/// A point tracked in a video, around a joint: for a channel in rad the angle from `zero`, from x towards y, continued
/// from turn to turn; for one in m the distance.
struct TrackedPoint {
  std::string other;  ///< the column of y; that of x is the mapping's. Empty: not a tracked point
  std::array<double, 2> pivot = {0.0, 0.0};  ///< m, in x and y
  double zero = 0.0;                         ///< rad
};

/// A column of a file and its meaning. SI value = column × unit × gain + offset, or the rate of change of that.
struct ColumnMapping {
  std::string channel;  ///< name of the sensor's channel or the actuator
  std::string column;   ///< header name
  std::string unit = "1";
  double gain = 1.0;      ///< channel unit (SI) per SI unit of the column
  std::string gain_unit;  ///< unit in which `gain` was written, e.g. "mN/V"; empty: none given
  double offset = 0.0;    ///< channel unit, added after the gain
  double noise = std::numeric_limits<double>::quiet_NaN();  ///< declared standard deviation, channel unit
  bool derivative = false;  ///< for a command: the channel is the rate of change of the column, by central differences
  Encoding encoding;        ///< encoding of the numbers
  bool keeps_glitches = false;  ///< for a sensor: keeps readings that look like glitches
  bool keeps_repeats = false;   ///< for a sensor: uses each row as a reading, even if it repeats the one before
  TrackedPoint track;           ///< for a sensor: the column is x of a point
  std::string enabled_by;       ///< for a command: a column that is 0 while the actuator is off; empty: it is never off
  SourceLocation location;
};

/// The control law that made an actuator's commands from a sensor's readings (recorded_controller.h).
struct ControllerMapping {
  std::string actuator;
  std::string sensor;                                      ///< the channel that it reads
  ColumnMapping reference;                                 ///< setpoint of that channel
  double proportional = 0.0;                               ///< command's unit per sensor's unit
  double derivative = 0.0;                                 ///< command's unit × s per sensor's unit
  double integral = 0.0;                                   ///< command's unit per sensor's unit and s
  double limit = std::numeric_limits<double>::infinity();  ///< limit of the command's magnitude, in its unit
  double filter = 0.0;            ///< s, time constant of a low-pass for the derivative; 0: none
  std::string proportional_unit;  ///< as written; empty: none
  std::string derivative_unit;
  std::string integral_unit;
  SourceLocation location;
};

struct TimeRange {
  double start = 0.0;  ///< s, inclusive, in the file's time
  double end = 0.0;    ///< s, inclusive
};

/// Known state of an element at the start of each trial, by its name: of a joint its state, of an actuator its earlier
/// command.
struct KnownStart {
  InitialValue joint = {};
  std::optional<double> command = {};  ///< the actuator's unit, SI; none: not known
  bool states_joint = true;            ///< whether the file gives a joint's state
  SourceLocation location = {};
};

/// A number of a clock: its value, or nothing, and then it is estimated from the readings.
using KnownOrFound = std::optional<double>;

/// A further file of a trial, from another logger with its own clock: at time t of the first file that clock shows t −
/// offset − skew·(t since this file's first sample); both are small.
struct FurtherFile {
  std::filesystem::path path = {};
  std::string table = {};  ///< of a file with several, such as a topic; empty: the only one
  std::vector<std::string> columns =
      {};                        ///< columns taken from this file, even if the first has them; empty: those that it has
  std::string time_column = {};  ///< empty: as `RecordingSource::time_column`
  std::string time_unit = {};    ///< empty: as `RecordingSource::time_unit`
  KnownOrFound offset = 0.0;     ///< s, added to this file's time stamps
  KnownOrFound skew = 0.0;       ///< 1, of the time since its first sample, also added
  std::pair<double, double> between = {-std::numeric_limits<double>::infinity(),
                                       std::numeric_limits<double>::infinity()};  ///< s, search range of an offset
  SourceLocation location = {};
};

struct MeasuredFile {
  std::filesystem::path path = {};  ///< resolved: relative to the experiment file, variables replaced
  bool held_out = false;
  SourceLocation location = {};                    ///< its place in the experiment file
  std::vector<TimeRange> use = {};                 ///< ranges of this file; empty: those of `RecordingSource::use`
  std::vector<TimeRange> mask = {};                ///< of this file, in addition to `RecordingSource::mask`
  std::vector<TimeRange> holdout = {};             ///< held-out parts of a fit file
  Setup setup = {};                                ///< named after the file where it has set or own values
  std::vector<std::string> own = {};               ///< address patterns: unknown values of this file alone
  std::map<std::string, KnownStart> initial = {};  ///< of this file, where different from `RecordingSource::initial`
  std::string key = {};                            ///< "target.recording[0]"
  std::vector<FurtherFile> with = {};              ///< of the same trial
  std::string table = {};  ///< of a file with several: the table that sets the trial's rows; empty: the first sensor's
};

struct RecordingSource {
  std::vector<MeasuredFile> files;
  bool may_split = false;  ///< no setting for held-out data: the last quarter of a single trial is held out
  std::string time_column = "t";
  std::string time_unit = "s";
  Encoding time_encoding;
  std::string trial_column;                 ///< non-empty: distinguishes several trials in a file
  std::vector<std::string> holdout_trials;  ///< values of `trial_column` that are held out
  char delimiter = '\0';                    ///< '\0': found out
  bool decimal_comma = false;               ///< also detected where the delimiter is not a comma
  std::vector<ColumnMapping> sensors;
  std::vector<ColumnMapping> commands;
  std::vector<ControllerMapping> controllers;  ///< of actuators whose commands come from feedback
  bool by_controllers = false;                 ///< models are driven by the controllers, not by the recorded commands
  Hold hold = Hold::zero_order;
  std::vector<TimeRange> use;   ///< empty: everything
  std::vector<TimeRange> mask;  ///< not compared
  double max_gap = 0.0;         ///< s; a longer gap between samples is a problem; 0: ten times the median interval
  std::map<std::string, KnownStart> initial;  ///< by name of joint or actuator
};

}  // namespace lacuna
