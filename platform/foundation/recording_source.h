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

/// How measured files are to be read: what `[target]` of kind "recorded" says.

/// A point that a video was searched for, seen from the joint that it goes round: of a channel in rad the angle from
/// `zero`, from x towards y, on from turn to turn; of one in m the distance.
struct TrackedPoint {
  std::string other;  ///< the column of y; that of x is the mapping's. Empty: there is no such point
  std::array<double, 2> pivot = {0.0, 0.0};  ///< m, in x and y
  double zero = 0.0;                         ///< rad
};

/// A column of a file and what it means. SI value = column × unit × gain + offset, or the rate of change of that.
struct ColumnMapping {
  std::string channel;  ///< the sensor's channel or the actuator it stands for
  std::string column;   ///< header name
  std::string unit = "1";
  double gain = 1.0;      ///< channel unit (SI) per column's SI unit
  std::string gain_unit;  ///< unit in which `gain` was written, e.g. "mN/V"; empty: none given
  double offset = 0.0;    ///< channel unit, added after the gain
  double noise = std::numeric_limits<double>::quiet_NaN();  ///< declared standard deviation, channel unit
  bool derivative = false;  ///< of a command: the channel is the rate of change of the column, by central differences
  Encoding encoding;        ///< of the numbers as written
  bool keeps_glitches = false;  ///< of a sensor: compares readings that look like glitches
  bool keeps_repeats = false;   ///< of a sensor: takes each row for a reading, also where it repeats the one before
  TrackedPoint track;           ///< of a sensor: the column is x of a point
  std::string enabled_by;       ///< of a command: a column that is 0 while the actuator is off; empty: it never is
  SourceLocation location;
};

/// The law by which a controller made an actuator's commands from a sensor's readings (recorded_controller.h).
struct ControllerMapping {
  std::string actuator;
  std::string sensor;                                      ///< the channel that it reads
  ColumnMapping reference;                                 ///< what that channel should be
  double proportional = 0.0;                               ///< command's unit per sensor's unit
  double derivative = 0.0;                                 ///< command's unit × s per sensor's unit
  double integral = 0.0;                                   ///< command's unit per sensor's unit and s
  double limit = std::numeric_limits<double>::infinity();  ///< of the command's size, its unit
  double filter = 0.0;            ///< s, time constant of a low-pass on what the derivative sees; 0: none
  std::string proportional_unit;  ///< as written; empty: none
  std::string derivative_unit;
  std::string integral_unit;
  SourceLocation location;
};

struct TimeRange {
  double start = 0.0;  ///< s, inclusive, in the file's own time
  double end = 0.0;    ///< s, inclusive
};

/// What is known of an element at the start of each trial, by its name: of a joint its state, of an actuator what it
/// was commanded before.
struct KnownStart {
  InitialValue joint = {};
  std::optional<double> command = {};  ///< the actuator's unit, SI; none: not known
  bool states_joint = true;            ///< whether something is said of a joint
  SourceLocation location = {};
};

/// What is known of a clock's number: its value, or nothing, and then it is found in the readings.
using KnownOrFound = std::optional<double>;

/// A further file of a trial, by another logger with a clock of its own: what that clock shows at the time t of the
/// first file is t − offset − skew·(t since this file's first sample), both small.
struct FurtherFile {
  std::filesystem::path path = {};
  std::string table = {};                 ///< of a file with several, such as a topic; empty: the only one
  std::vector<std::string> columns = {};  ///< taken from this file, also where the first has them; empty: what it has
  std::string time_column = {};           ///< empty: as `RecordingSource::time_column`
  std::string time_unit = {};             ///< empty: as `RecordingSource::time_unit`
  KnownOrFound offset = 0.0;              ///< s, added to this file's time stamps
  KnownOrFound skew = 0.0;                ///< 1, of the time since its first sample, added too
  std::pair<double, double> between = {-std::numeric_limits<double>::infinity(),
                                       std::numeric_limits<double>::infinity()};  ///< s, where an offset is looked for
  SourceLocation location = {};
};

struct MeasuredFile {
  std::filesystem::path path = {};  ///< resolved: relative to the experiment file, variables replaced
  bool held_out = false;
  SourceLocation location = {};                    ///< where the experiment names it
  std::vector<TimeRange> use = {};                 ///< of this file; empty: as `RecordingSource::use` says
  std::vector<TimeRange> mask = {};                ///< of this file, besides `RecordingSource::mask`
  std::vector<TimeRange> holdout = {};             ///< stretches of a file to fit to that are kept from every fit
  Setup setup = {};                                ///< named after the file where it sets something or has own values
  std::vector<std::string> own = {};               ///< address patterns: unknown, and of this file alone
  std::map<std::string, KnownStart> initial = {};  ///< of this file, where they differ from `RecordingSource::initial`
  std::string key = {};                            ///< "target.recording[0]"
  std::vector<FurtherFile> with = {};              ///< of the same trial
  std::string table = {};  ///< of a file with several: whose rows the trial has; empty: the first sensor's
};

struct RecordingSource {
  std::vector<MeasuredFile> files;
  bool may_split = false;  ///< nothing is said of what is held out: the last quarter of one trial alone is to be
  std::string time_column = "t";
  std::string time_unit = "s";
  Encoding time_encoding;
  std::string trial_column;                 ///< non-empty: tells several trials in a file apart
  std::vector<std::string> holdout_trials;  ///< values of `trial_column` that are held out
  char delimiter = '\0';                    ///< '\0': found out
  bool decimal_comma = false;               ///< also found out where the delimiter is not a comma
  std::vector<ColumnMapping> sensors;
  std::vector<ColumnMapping> commands;
  std::vector<ControllerMapping> controllers;  ///< of actuators whose commands were made by feedback
  bool by_controllers = false;                 ///< models are driven by the controllers, not by the recorded commands
  Hold hold = Hold::zero_order;
  std::vector<TimeRange> use;   ///< empty: everything
  std::vector<TimeRange> mask;  ///< not compared
  double max_gap = 0.0;         ///< s; a longer pause between samples is a problem; 0: ten times the median interval
  std::map<std::string, KnownStart> initial;  ///< by name of joint or actuator
};

}  // namespace lacuna
