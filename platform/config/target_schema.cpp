#include "config/experiment_schema.h"

#include "config/blank.h"
#include "config/path_variables.h"
#include "foundation/unit.h"

#include <limits>
#include <tuple>

namespace lacuna {
namespace {

constexpr auto kLargestSeed = std::numeric_limits<std::int64_t>::max();

Value<std::vector<MeasuredFile>> measured_files(bool held_out, std::size_t fewest) {
  const Value<std::filesystem::path> path = existing_file();
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

/// A file with what holds for it alone.
Table<MeasuredFile> recorded_file_keys() {
  return Table<MeasuredFile>()
      .required("file", &MeasuredFile::path, existing_file(), "the measured file")
      .key("role", &MeasuredFile::held_out, choice<bool>({{"fit", false}, {"holdout", true}}),
           "fitted to, or kept from every fit")
      .key("use", &MeasuredFile::use, time_ranges(), "only these times of it, instead of target.time.use")
      .key("mask", &MeasuredFile::mask, time_ranges(), "times of it that are not compared, besides target.time.mask")
      .key("holdout", &MeasuredFile::holdout, time_ranges(),
           "stretches of a file to fit to that are kept from every fit, [start, end]: each is a trial of its own")
      .check({"role", "holdout"},
             [](const TomlNode& node, Reading& reading, MeasuredFile& file) {
               if (file.held_out && !file.holdout.empty())
                 reading.problem_at("holdout", node.find("holdout")->location,
                                    "the whole file is held out already; leave out role or holdout");
             })
      .located(&MeasuredFile::location);
}

/// The unit of a column as written; what it is converted to is the reader's business.
Value<std::string> unit_name() {
  Value<std::string> value = text();
  value.shape.meaning = "a unit such as deg, mm, N*m";
  value.read = [plain = text()](const TomlNode& node, Reading& reading, std::string& result) {
    if (!plain.read(node, reading, result)) return false;
    if (parse_unit(result)) return true;
    reading.problem(node, is_blank(result) ? blank_complaint(result, "")
                                           : toml_text(result) + " is no unit; known are " + known_units());
    return false;
  };
  return value;
}

Value<std::string> time_unit() {
  Value<std::string> value = unit_name();
  value.shape.meaning = "a unit of time such as s, ms";
  value.read = [unit = unit_name()](const TomlNode& node, Reading& reading, std::string& result) {
    if (!unit.read(node, reading, result)) return false;
    if (parse_unit(result)->same_dimension(*parse_unit("s"))) return true;
    reading.problem(node, toml_text(result) + " is no unit of time; write s, ms, us or min");
    return false;
  };
  return value;
}

/// A factor, which remembers the unit it was written with.
struct Gain {
  double value = 1.0;
  std::string unit;
};

Value<Gain> gain() {
  const NumberValue plain = number("");
  Value<Gain> value;
  value.shape = plain.shape;
  value.read = [plain](const TomlNode& node, Reading& reading, Gain& result) {
    if (!plain.read(node, reading, result.value)) return false;
    const auto written = reading.written_units().find(reading.path());
    if (node.kind == TomlNode::Kind::text && written != reading.written_units().end()) result.unit = written->second;
    if (result.value != 0.0) return true;
    reading.problem(node, "a gain of zero leaves nothing of the column");
    return false;
  };
  value.write = [](const Gain& shown) { return toml_number(shown.value); };
  return value;
}

Table<ColumnMapping> column_keys() {
  return Table<ColumnMapping>()
      .required("column", &ColumnMapping::column, text(), "the column's name in the file's header")
      .required("unit", &ColumnMapping::unit, unit_name(), "what the column is measured in; \"1\" for a plain number")
      .key<Gain>(
          "gain", gain(), {},
          [](ColumnMapping& mapping, Gain&& read) {
            mapping.gain = read.value;
            mapping.gain_unit = read.unit;
          },
          "the channel is the column times this, as in \"35.15065 N/V\"")
      .key("offset", &ColumnMapping::offset, number(""), "added after the gain, in the channel's unit")
      .key("noise", &ColumnMapping::noise, number("").at_least(0.0),
           "standard deviation of the measurement, in the channel's unit")
      .located(&ColumnMapping::location);
}

Value<std::vector<ColumnMapping>> columns(const std::string& name_hint) {
  return named<std::vector<ColumnMapping>, ColumnMapping>(
      name_hint, column_keys().value(),
      [](std::vector<ColumnMapping>& mappings, const TomlMember& member, ColumnMapping&& mapping) {
        mapping.channel = member.name;
        mappings.push_back(std::move(mapping));
      });
}

using GainOf = double ControllerMapping::*;
using UnitOf = std::string ControllerMapping::*;

auto set_gain(GainOf value, UnitOf unit) {
  return [value, unit](ControllerMapping& mapping, Gain&& read) {
    mapping.*value = read.value;
    mapping.*unit = read.unit;
  };
}

Table<ColumnMapping> reference_keys() {
  return Table<ColumnMapping>()
      .required("column", &ColumnMapping::column, text(), "the column's name in the file's header")
      .required("unit", &ColumnMapping::unit, unit_name(), "what the column is measured in")
      .located(&ColumnMapping::location);
}

Table<ControllerMapping> controller_keys() {
  return Table<ControllerMapping>()
      .required("reads", &ControllerMapping::sensor, text(), "the sensor (its channel) that is fed back")
      .required("reference", &ControllerMapping::reference, reference_keys().value(),
                "the column of what the sensor should read, as in { column = \"wanted\", unit = \"rad\" }")
      .key<Gain>("proportional", gain(), {},
                 set_gain(&ControllerMapping::proportional, &ControllerMapping::proportional_unit),
                 "command per difference of reference and reading, as in \"8 N*m/rad\"")
      .key<Gain>("derivative", gain(), {},
                 set_gain(&ControllerMapping::derivative, &ControllerMapping::derivative_unit),
                 "command against the reading's change from sample to sample, as in \"0.2 N*m*s/rad\"")
      .located(&ControllerMapping::location);
}

Value<std::vector<ControllerMapping>> controllers() {
  return named<std::vector<ControllerMapping>, ControllerMapping>(
      "ACTUATOR", controller_keys().value(),
      [](std::vector<ControllerMapping>& mappings, const TomlMember& member, ControllerMapping&& mapping) {
        mapping.actuator = mapping.reference.channel = member.name;
        mappings.push_back(std::move(mapping));
      });
}

Table<RecordingSource> time_keys() {
  return Table<RecordingSource>()
      .key("column", &RecordingSource::time_column, text(), "the column of time stamps")
      .key("unit", &RecordingSource::time_unit, time_unit(), "their unit")
      .key("max_gap", &RecordingSource::max_gap, number("s").at_least(0.0),
           "a longer pause between samples is a problem; 0: ten times the median interval")
      .key("use", &RecordingSource::use, time_ranges(), "only these times, [start, end]; empty: all")
      .key("mask", &RecordingSource::mask, time_ranges(), "times that are not compared");
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
           "exact, estimated from the first 50 ms (which are then not scored), or fitted with the parameters");
}

Table<KnownStart> initial_keys() {
  return Table<KnownStart>()
      .merged(&KnownStart::joint, joint_start_keys())
      .key(
          "command", &KnownStart::command, number(""),
          "of an actuator: what it was commanded before the first sample, in the unit of its commands; without it, "
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

Value<char> delimiter() { return choice<char>({{"auto", '\0'}, {",", ','}, {";", ';'}, {"\t", '\t'}, {" ", ' '}}); }

Table<RecordingSource> recording_keys() {
  return Table<RecordingSource>()
      .key<std::vector<MeasuredFile>>("files", measured_files(false, 1), {}, append_files,
                                      "recorded: measured files to fit to; required")
      .key<std::vector<MeasuredFile>>("holdout", measured_files(true, 0), {}, append_files,
                                      "recorded: files kept from every fit; only compare and history read them")
      .key<std::vector<MeasuredFile>>("recording", list_of(recorded_file_keys().value()), {}, append_files,
                                      "recorded: files with what holds for each alone, as [[target.recording]]; beside "
                                      "or instead of files and holdout")
      .key("delimiter", &RecordingSource::delimiter, delimiter(), "between columns; \"auto\": found out")
      .key("decimal_comma", &RecordingSource::decimal_comma, boolean(), "numbers are written as 3,14")
      .key("trial_column", &RecordingSource::trial_column, text(0), "column that tells several trials in a file apart")
      .key("holdout_trials", &RecordingSource::holdout_trials, list_of(text()),
           "values of trial_column that are kept from every fit")
      .key("hold", &RecordingSource::hold, choice<Hold>({{"zero", Hold::zero_order}, {"first", Hold::first_order}}),
           "between two samples a command stays (zero) or goes on a straight line (first)")
      .section("time", time_keys(), "Time stamps.")
      .key("sensors", &RecordingSource::sensors, columns("SENSOR"),
           "What was measured: each table is named like the robot's sensor (its channel) that reads the same.")
      .key("commands", &RecordingSource::commands, columns("ACTUATOR"),
           "What was applied: each table is named like the robot's actuator that gets the command.")
      .key("controllers", &RecordingSource::controllers, controllers(),
           "What made the commands, where a controller did: each table is named like the actuator. `lacuna diagnose` "
           "then also fits with the controller in the loop, and says where the feedback biases what is identified.")
      .key("initial", &RecordingSource::initial, map_of("JOINT_OR_ACTUATOR", initial_keys().value()),
           "What is known at the start of each trial: of a joint its position and velocity (joints not named here are "
           "taken from the data), of an actuator what it was commanded before.");
}

void check_trials(const TomlNode& node, Reading& reading, RecordingSource& source) {
  if (source.holdout_trials.empty() || !source.trial_column.empty()) return;
  reading.problem_at("holdout_trials", node.find("holdout_trials")->location,
                     "needs trial_column, which tells the trials apart");
}

/// `{ uniform = [1.0, 7.0] }`.
Value<FreeRange> hidden_range() {
  return Table<FreeRange>()
      .required<std::pair<double, double>>(
          "uniform", range_of(number("")),
          [](FreeRange& range, std::pair<double, double>&& read) { std::tie(range.lower, range.upper) = read; },
          "the value is drawn from between these two")
      .value();
}

Table<ModelSection> hidden_keys() {
  return system_keys("target").key(
      "hidden", &ModelSection::free,
      named<std::vector<FreeRange>, FreeRange>(
          "ADDRESS", hidden_range(),
          [](std::vector<FreeRange>& ranges, const TomlMember& member, FreeRange&& range) {
            range.pattern = member.name;
            ranges.push_back(std::move(range));
          }),
      "Values that nobody knows, each drawn by itself, as in \"body.*.mass\" = { uniform = [1.0, 7.0] }");
}

Table<SimulatedSource> simulated_keys() {
  return Table<SimulatedSource>()
      .merged(&SimulatedSource::system, hidden_keys())
      .key("hidden_seed", &SimulatedSource::hidden_seed, whole_number<std::uint64_t>(0, kLargestSeed),
           "simulated: of the hidden values")
      .key("redraw", &SimulatedSource::redraw,
           choice<Redraw>({{"never", Redraw::never}, {"replicate", Redraw::replicate}}),
           "simulated: whether each replicate has hidden values of its own")
      .key("noise", &SimulatedSource::noise, map_of("SENSOR", number("").at_least(0.0)),
           "simulated: standard deviation of white measurement noise, as in \"sensor.angle*\" = 0.002")
      .key(
          "substeps", &SimulatedSource::substeps, whole_number<int>(0, 1000000),
          "simulated: integration steps in one of engine.step, where they are to be others than those of models, which "
          "have engine.substeps; 0: the same");
}

/// A folder that is there, variables replaced, from the experiment file's.
Value<std::filesystem::path> existing_folder() {
  Value<std::filesystem::path> value;
  value.shape.kind = Shape::Kind::text;
  value.shape.meaning = "a folder's path";
  value.read = [plain = text()](const TomlNode& node, Reading& reading, std::filesystem::path& result) {
    std::string written;
    if (!plain.read(node, reading, written)) return false;
    try {
      result = reading.directory() / replace_variables(written);
      if (std::filesystem::is_directory(result)) return true;
      reading.problem(node, toml_text(written) + " is no folder; paths are taken from the experiment file's");
    } catch (const Error& error) {
      reading.problem(node, error.what());
    }
    return false;
  };
  value.write = [](const std::filesystem::path& shown) { return shown.empty() ? "" : toml_text(shown.string()); };
  return value;
}

/// A text in which variables such as `${HOME}` are replaced.
Value<std::string> text_with_variables() {
  Value<std::string> value = text();
  value.read = [plain = text()](const TomlNode& node, Reading& reading, std::string& result) {
    if (!plain.read(node, reading, result)) return false;
    try {
      result = replace_variables(result);
      return true;
    } catch (const Error& error) {
      reading.problem(node, error.what());
      return false;
    }
  };
  return value;
}

}  // namespace

Table<ProcessSource> process_keys() {
  return Table<ProcessSource>()
      .key("command", &ProcessSource::command, list_of(text_with_variables(), 1),
           "process: the program and its arguments, as in [\"python3\", \"rig.py\"]; it speaks the protocol of "
           "docs/reference/process-target.md on its standard input and output")
      .key("folder", &ProcessSource::folder, existing_folder(),
           "process: that the program works in; without it the experiment file's")
      .key("environment", &ProcessSource::environment, map_of("NAME", text_with_variables()),
           "process: variables that the program gets besides those of lacuna")
      .key("start_limit", &ProcessSource::start_limit, number("s").above(0.0),
           "process: how long the program may take until it has said hello")
      .key("trial_limit", &ProcessSource::trial_limit, number("s").above(0.0),
           "process: how much longer than the test itself a trial may take")
      .key("repeats", &ProcessSource::repeats, whole_number<int>(0, 1000),
           "process: how often `lacuna run` tries a test again that failed before it takes another one")
      .key("pause", &ProcessSource::pause, number("s").at_least(0.0),
           "process: how long `lacuna run` waits after a test that failed before it tries again")
      .key("copies", &ProcessSource::copies, whole_number<int>(1, 1000),
           "process: how many of the program may run at the same time; a rig is one, replicates wait for it")
      .key("version", &ProcessSource::version, text(),
           "process: another text for a target that has changed, whose trials so far are then left out");
}

namespace {

/// Of each kind of target the keys that others do not have.
void check_kind(const TomlNode& node, Reading& reading, TargetSection& target) {
  const std::vector<std::pair<std::string, Shape>> kinds = {{"recorded", recording_keys().value().shape},
                                                            {"simulated", simulated_keys().value().shape},
                                                            {"process", process_keys().value().shape}};
  for (const auto& [kind, shape] : kinds)
    for (const KeyShape& key : shape.keys) {
      const TomlNode* found = kind == target.kind ? nullptr : node.find(key.name);
      if (found) reading.problem_at(key.name, found->location, "is a key of kind = " + toml_text(kind));
    }
  std::string& robot = target.simulated.system.robot;
  if (target.kind == "simulated" && robot.empty() && node.find("file")) robot = "declared";
  if (target.kind == "process" && target.process.folder.empty()) target.process.folder = reading.directory();
  struct Need {
    const char *kind, *key, *complaint;
  };
  static constexpr Need kNeeds[] = {
      {"recorded", "files", "is missing: measured files to fit to (a list of at least 1, each a file's path)"},
      {"simulated", "robot", "is missing: a robot plugin's name, or file = \"robot.toml\""},
      {"process", "command", "is missing: the program and its arguments, as in [\"python3\", \"rig.py\"]"}};
  const bool has_recording = target.kind == "recorded" && node.find("recording");
  for (const Need& need : kNeeds)
    if (target.kind == need.kind && !node.find(need.key) && !has_recording &&
        !(target.kind == "simulated" && node.find("file")))
      reading.problem_at(need.key, node.location, need.complaint);
}

}  // namespace

Table<TargetSection> target_keys() {
  return Table<TargetSection>()
      .key("kind", &TargetSection::kind, text_of({"recorded", "simulated", "process"}),
           "what the target is: measured files, a robot that is simulated with values hidden from the search, or a "
           "program of its own, such as a rig's driver or another simulator")
      .merged(&TargetSection::recording, recording_keys().check({"holdout_trials", "trial_column"}, check_trials))
      .merged(&TargetSection::simulated, simulated_keys())
      .merged(&TargetSection::process, process_keys())
      .check({"kind"}, check_kind);
}

}  // namespace lacuna
