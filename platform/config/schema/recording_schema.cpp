#include "config/schema/experiment_schema.h"

#include "config/schema/column_schema.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <map>
#include <set>

namespace lacuna {
namespace {

Value<std::vector<MeasuredFile>> measured_files(bool held_out, std::size_t fewest) {
  const Value<std::filesystem::path> path = existing_recording();
  Value<MeasuredFile> file;
  file.shape = path.shape;
  file.read = [path, held_out](const TomlNode& node, Reading& reading, MeasuredFile& result) {
    result.held_out = held_out;
    result.location = node.location;
    return path.read(node, reading, result.path);
  };
  file.write = [path](const MeasuredFile& shown) { return path.write(shown.path); };
  return list_of(file, fewest);
}

void append_files(RecordingSource& source, std::vector<MeasuredFile>&& files) {
  source.files.insert(source.files.end(), files.begin(), files.end());
}

Value<std::vector<TimeRange>> time_ranges() {
  return list_of(
      mapped<TimeRange, std::pair<double, double>>(range_of(number("s")), [](std::pair<double, double>&& range) {
        return TimeRange{range.first, range.second};
      }));
}

/// "heavy load 2.csv" → "heavy_load_2": part of addresses, so without dots.
std::string setup_name(const std::filesystem::path& file) {
  std::string name = file.stem().string();
  std::replace_if(
      name.begin(), name.end(),
      [](char c) { return !std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-'; }, '_');
  return name;
}

void check_drive(const TomlNode& node, Reading& reading, RecordingSource& source) {
  if (source.by_controllers && source.controllers.empty())
    reading.problem_at("drive", node.find("drive")->location, "needs the control laws in target.controllers");
  for (const ColumnMapping& command : source.commands)
    if (source.by_controllers && !command.enabled_by.empty())
      reading.problem_at(
          "commands." + command.channel, command.location,
          "enabled_by needs drive = \"commands\", because a controller does not know when the actuator is off");
}

void check_clock(const TomlNode& node, Reading& reading, RecordingSource& source) {
  const EncodingKind kind = source.time_encoding.kind;
  if (kind == EncodingKind::sign_bit || kind == EncodingKind::twos_complement)
    reading.problem_at("encoding", node.find("encoding")->location,
                       "write \"plain\", or \"wraps\" and a number, as in \"wraps 2^32\"");
}

/// An empty list says that nothing is to be held out.
void look_for_holdout(const TomlNode& node, Reading&, RecordingSource& source) {
  source.may_split = node.find("holdout") == nullptr && source.trial_column.empty();
}

void name_setups(const TomlNode&, Reading&, RecordingSource& source) {
  std::set<std::string> used;
  for (MeasuredFile& file : source.files) {
    if (file.setup.values.empty() && file.own.empty()) continue;
    const std::string name = setup_name(file.path);
    file.setup.name = name;
    for (int i = 2; !used.insert(file.setup.name).second; ++i) file.setup.name = name + "_" + std::to_string(i);
  }
}

Table<RecordingSource> time_keys() {
  return Table<RecordingSource>()
      .key("column", &RecordingSource::time_column, text(), "column of time stamps")
      .key("unit", &RecordingSource::time_unit, time_unit(), "their unit")
      .key("encoding", &RecordingSource::time_encoding, encoding(),
           "format of the clock. plain: as it is; wraps 2^32: restarts there; auto: recognised from the column")
      .key("max_gap", &RecordingSource::max_gap, number("s").at_least(0.0),
           "longest allowed interval between samples; 0: ten times the median interval")
      .key("use", &RecordingSource::use, time_ranges(), "use only these times, [start, end]; empty: all")
      .key("mask", &RecordingSource::mask, time_ranges(), "times that are not compared")
      .check({"encoding"}, check_clock);
}

Table<InitialValue> joint_start_keys() {
  return Table<InitialValue>()
      .key("position", &InitialValue::position, number("rad or m"),
           "position of the joint at the start, or first guess")
      .key("velocity", &InitialValue::velocity, number("rad/s or m/s"), "velocity at the start, or first guess")
      .key("knowledge", &InitialValue::knowledge,
           choice<InitialKnowledge>({{"given", InitialKnowledge::given},
                                     {"from_data", InitialKnowledge::from_data},
                                     {"free", InitialKnowledge::free}}),
           "exact; estimated from the first 50 ms, which are then not scored; or fitted with the parameters");
}

Table<KnownStart> initial_keys() {
  return Table<KnownStart>()
      .merged(&KnownStart::joint, joint_start_keys())
      .key(
          "command", &KnownStart::command, number(""),
          "of an actuator: its command before the first sample, in the unit of its commands; default: "
          "what "
          "holds a robot that is given at rest, else the first 100 ms are not scored where commands or readings may be "
          "late")
      .check({},
             [](const TomlNode& node, Reading&, KnownStart& start) {
               start.states_joint = false;
               for (const char* key : {"position", "velocity", "knowledge"})
                 start.states_joint = start.states_joint || node.find(key) != nullptr;
             })
      .located(&KnownStart::location);
}

/// A number, or "auto": it is found in the readings.
Value<KnownOrFound> known_or_found(const std::string& unit) {
  const NumberValue known = number(unit);
  Value<KnownOrFound> value;
  value.shape.kind = Shape::Kind::either;
  value.shape.parts = {text_of({"auto"}).shape, known.shape};
  value.read = [known, shape = value.shape](const TomlNode& node, Reading& reading, KnownOrFound& result) {
    result.reset();
    if (node.text == "auto") return true;
    const bool is_quantity = node.is_number() || node.text.find_first_of("0123456789") != std::string::npos;
    if (!is_quantity) report_mismatch(shape, node, reading);
    return is_quantity && known.read(node, reading, result.emplace());
  };
  value.write = [](const KnownOrFound& shown) { return shown ? toml_number(*shown) : toml_text("auto"); };
  return value;
}

Table<FurtherFile> further_file_keys() {
  return Table<FurtherFile>()
      .required("file", &FurtherFile::path, existing_recording(), "further file of the same trial, with another clock")
      .key("table", &FurtherFile::table, text(0),
           "for a file with several tables, such as the topics of a bag: the table to join; empty: the only one")
      .key("columns", &FurtherFile::columns, list_of(text()),
           "columns to take from it; empty: all columns of the experiment that only this file has")
      .key("time_column", &FurtherFile::time_column, text(), "its column of time stamps, if different")
      .key("time_unit", &FurtherFile::time_unit, time_unit(), "unit of its time stamps, if different")
      .key("offset", &FurtherFile::offset, known_or_found("s"),
           "timestamp offset that is added to get times of the first file; \"auto\": found from the readings")
      .key("skew", &FurtherFile::skew, known_or_found("1"),
           "clock drift: this share of the time since its first sample is added too; \"auto\": found from the readings")
      .key("between", &FurtherFile::between, range_of(number("s").or_infinite()),
           "range in which an unknown offset is searched")
      .check({"between", "offset"},
             [](const TomlNode& node, Reading& reading, FurtherFile& file) {
               if (const TomlNode* between = node.find("between"); between && file.offset)
                 reading.problem_at("between", between->location,
                                    "is not needed for a known offset; leave it out, or write offset = \"auto\"");
             })
      .located(&FurtherFile::location);
}

/// A file with what holds for it alone.
Table<MeasuredFile> recorded_file_keys() {
  return Table<MeasuredFile>()
      .required("file", &MeasuredFile::path, existing_recording(), "the measured file")
      .key("table", &MeasuredFile::table, text(0),
           "for a file with several tables, such as the topics of a bag or the runs of an export (\"Run #2\"): the one "
           "whose "
           "times the trial has; empty: the table of the first sensor's column")
      .key("with", &MeasuredFile::with, list_of(further_file_keys().value()),
           "further files of the same trial, written by other devices with other clocks")
      .key("role", &MeasuredFile::held_out, choice<bool>({{"fit", false}, {"holdout", true}}),
           "fit trial, or held out of every fit")
      .key("use", &MeasuredFile::use, time_ranges(), "use only these times of the file, instead of target.time.use")
      .key("mask", &MeasuredFile::mask, time_ranges(),
           "times of the file that are not compared, in addition to target.time.mask")
      .key("holdout", &MeasuredFile::holdout, time_ranges(),
           "held-out parts of a fit file, [start, end]: each is a separate trial that no fit reads")
      .key<std::map<std::string, double>>(
          "set", map_of("ADDRESS", number("").or_infinite()), {},
          [](MeasuredFile& file, std::map<std::string, double>&& read) {
            for (const auto& [address, value] : read) file.setup.values.push_back({address, value});
          },
          "known values that differ in this file, as in { \"body.load.mass\" = \"0.49 kg\" }")
      .key("initial", &MeasuredFile::initial, map_of("JOINT_OR_ACTUATOR", initial_keys().value()),
           "known initial state of this file, for the joints and actuators for which it differs from "
           "target.initial")
      .key("own", &MeasuredFile::own, list_of(text()),
           "unknown values of this file alone, as in [\"body.load.mass\"]: each is fitted to the trials of this file, "
           "within the bounds of model.free")
      .check({"role", "holdout"},
             [](const TomlNode& node, Reading& reading, MeasuredFile& file) {
               if (file.held_out && !file.holdout.empty())
                 reading.problem_at("holdout", node.find("holdout")->location,
                                    "role holds out the whole file already; leave out role or holdout");
             })
      .check({}, [](const TomlNode&, Reading& reading, MeasuredFile& file) { file.key = reading.path(); })
      .located(&MeasuredFile::location);
}

Value<char> delimiter() { return choice<char>({{"auto", '\0'}, {",", ','}, {";", ';'}, {"\t", '\t'}, {" ", ' '}}); }

/// A column of trials, or a controller that acts at each sample, belongs to one file.
void check_further_files(const TomlNode&, Reading& reading, RecordingSource& source) {
  for (const MeasuredFile& file : source.files) {
    if (file.with.empty()) continue;
    const SourceLocation& location = file.with.front().location;
    if (!source.trial_column.empty())
      reading.problem_at("recording", location, "with needs files of one trial each; leave out trial_column");
    if (!source.controllers.empty())
      reading.problem_at(
          "recording", location,
          "with and target.controllers exclude each other, because a controller acts at each sample of one file");
  }
}

void check_trials(const TomlNode& node, Reading& reading, RecordingSource& source) {
  if (source.holdout_trials.empty() || !source.trial_column.empty()) return;
  reading.problem_at("holdout_trials", node.find("holdout_trials")->location,
                     "needs trial_column, the column that names the trials");
}

}  // namespace

Table<RecordingSource> recording_keys() {
  return Table<RecordingSource>()
      .key<std::vector<MeasuredFile>>("files", measured_files(false, 1), {}, append_files,
                                      "recorded: fit files (required)")
      .key<std::vector<MeasuredFile>>(
          "holdout", measured_files(true, 0), {}, append_files,
          "recorded: held-out files, which no fit reads. Without them, the last quarter of a single trial is held out")
      .key<std::vector<MeasuredFile>>("recording", list_of(recorded_file_keys().value()), {}, append_files,
                                      "recorded: files with individual settings, as [[target.recording]]; in addition "
                                      "to or instead of files and holdout")
      .key("delimiter", &RecordingSource::delimiter, delimiter(), "character between columns; \"auto\": recognised")
      .key("decimal_comma", &RecordingSource::decimal_comma, boolean(), "numbers are written like 3,14")
      .key("trial_column", &RecordingSource::trial_column, text(0),
           "column that names the trial of each row, for a file with several trials")
      .key("holdout_trials", &RecordingSource::holdout_trials, list_of(text()),
           "held-out trials: values of trial_column")
      .key("hold", &RecordingSource::hold, choice<Hold>({{"zero", Hold::zero_order}, {"first", Hold::first_order}}),
           "between two samples a command is constant (zero) or linear (first)")
      .section("time", time_keys(), "Time stamps.")
      .key("sensors", &RecordingSource::sensors, sensor_columns(),
           "Measured columns: each table has the name of the robot's sensor (its channel).")
      .key("commands", &RecordingSource::commands, command_columns(),
           "Applied commands: each table has the name of the robot's actuator.")
      .key("controllers", &RecordingSource::controllers, controllers(),
           "Controllers that made the commands: each table has the name of the actuator. `lacuna diagnose` then also "
           "fits with the controller in the loop and reports bias from the feedback.")
      .key("drive", &RecordingSource::by_controllers, choice<bool>({{"commands", false}, {"controllers", true}}),
           "what drives models: the recorded commands (open loop) or the controllers (closed loop)")
      .key("initial", &RecordingSource::initial, map_of("JOINT_OR_ACTUATOR", initial_keys().value()),
           "Known initial state of each trial: position and velocity of a joint (default: estimated from the data), "
           "earlier command of an actuator.")
      .check({"holdout_trials", "trial_column"}, check_trials)
      .check({"files", "holdout", "recording"}, name_setups)
      .check({"recording", "trial_column", "controllers"}, check_further_files)
      .check({}, look_for_holdout)
      .check({"drive", "controllers", "commands"}, check_drive);
}

}  // namespace lacuna
