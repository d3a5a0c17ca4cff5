#include "config/experiment_schema.h"

#include "config/blank.h"
#include "foundation/unit.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

namespace lacuna {
namespace {

constexpr double kTurn = 2.0 * M_PI;  // rad

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
    reading.problem_at("drive", node.find("drive")->location, "needs target.controllers, which say the laws");
  for (const ColumnMapping& command : source.commands)
    if (source.by_controllers && !command.enabled_by.empty())
      reading.problem_at("commands." + command.channel, command.location,
                         "enabled_by takes drive = \"commands\": a controller does not know when the actuator is off");
}

void check_clock(const TomlNode& node, Reading& reading, RecordingSource& source) {
  const EncodingKind kind = source.time_encoding.kind;
  if (kind == EncodingKind::sign_bit || kind == EncodingKind::twos_complement)
    reading.problem_at("encoding", node.find("encoding")->location,
                       "a clock is \"plain\" or \"wraps\" at a number, as in \"wraps 2^32\"");
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

Value<Encoding> encoding() {
  Value<Encoding> value;
  value.shape.kind = Shape::Kind::text;
  value.shape.meaning = "\"auto\", \"plain\", or sign_bit, twos_complement or wraps and a number such as 2^15";
  value.read = [plain = text()](const TomlNode& node, Reading& reading, Encoding& result) {
    std::string written;
    if (!plain.read(node, reading, written)) return false;
    const std::optional<Encoding> parsed = parse_encoding(written);
    if (parsed) result = *parsed;
    if (!parsed)
      reading.problem(node, toml_text(written) +
                                " is no encoding; write \"plain\", \"sign_bit 2^15\", "
                                "\"twos_complement 2^16\" or \"wraps 2^16\"");
    return parsed.has_value();
  };
  value.write = [](const Encoding& shown) { return toml_text(to_string(shown)); };
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
      .key<double>(
          "counts_per_turn", mapped<double, double>(number("1").above(0.0), [](double&& read) { return read; }), {},
          [](ColumnMapping& mapping, double&& read) {
            mapping.gain = kTurn / read;
            mapping.gain_unit = "rad";
          },
          "instead of gain: the column, with unit = \"1\", is a count of which a turn has so many")
      .check({"gain", "counts_per_turn"},
             [](const TomlNode& node, Reading& reading, ColumnMapping&) {
               const TomlNode* counts = node.find("counts_per_turn");
               if (counts && node.find("gain"))
                 reading.problem_at("counts_per_turn", counts->location, "gain says the same; keep one of them");
             })
      .key("offset", &ColumnMapping::offset, number(""), "added after the gain, in the channel's unit")
      .key(
          "encoding", &ColumnMapping::encoding, encoding(),
          "how the device wrote the numbers: plain; sign_bit 2^15, from there on minus what is beyond; twos_complement "
          "2^16, in the upper half less that; wraps 360, a count that starts again; auto: as the column shows")
      .key("noise", &ColumnMapping::noise, number("").at_least(0.0),
           "standard deviation of the measurement, in the channel's unit")
      .located(&ColumnMapping::location);
}

enum class Kept { glitches, repeats };

Table<ColumnMapping> sensor_column_keys() {
  return column_keys().key<std::vector<Kept>>(
      "keep", list_of(choice<Kept>({{"glitches", Kept::glitches}, {"repeats", Kept::repeats}})), {},
      [](ColumnMapping& mapping, std::vector<Kept>&& kept) {
        for (const Kept one : kept) (one == Kept::glitches ? mapping.keeps_glitches : mapping.keeps_repeats) = true;
      },
      "readings that are compared although they look as if they were never taken");
}

Table<ColumnMapping> command_column_keys() {
  return column_keys()
      .key("derivative", &ColumnMapping::derivative, boolean(),
           "the command is the rate of change of the column, by central differences: of a recorded position the "
           "velocity that is imposed")
      .key("enabled_by", &ColumnMapping::enabled_by, text(0),
           "a column that is 0 while the actuator is off: it then exerts nothing");
}

Value<std::vector<ColumnMapping>> columns(const std::string& name_hint, const Table<ColumnMapping>& keys) {
  return named<std::vector<ColumnMapping>, ColumnMapping>(
      name_hint, keys.value(),
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
      .key<Gain>("integral", gain(), {}, set_gain(&ControllerMapping::integral, &ControllerMapping::integral_unit),
                 "command per integral of that difference, as in \"2 N*m/(rad*s)\"")
      .key("limit", &ControllerMapping::limit, number("").above(0.0).or_infinite(),
           "the command stays between minus this and this, in its unit")
      .key("filter", &ControllerMapping::filter, number("s").at_least(0.0),
           "time constant of a first-order low-pass before the derivative; 0: none")
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
      .key("encoding", &RecordingSource::time_encoding, encoding(),
           "how the clock wrote them: plain; wraps 2^32, starting again there; auto: as the column shows")
      .key("max_gap", &RecordingSource::max_gap, number("s").at_least(0.0),
           "a longer pause between samples is a problem; 0: ten times the median interval")
      .key("use", &RecordingSource::use, time_ranges(), "only these times, [start, end]; empty: all")
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
      .key<std::map<std::string, double>>(
          "set", map_of("ADDRESS", number("").or_infinite()), {},
          [](MeasuredFile& file, std::map<std::string, double>&& read) {
            for (const auto& [address, value] : read) file.setup.values.push_back({address, value});
          },
          "what was different in this file and is known, as in { \"body.load.mass\" = \"0.49 kg\" }")
      .key("initial", &MeasuredFile::initial, map_of("JOINT_OR_ACTUATOR", initial_keys().value()),
           "what is known at the start of this file, of the joints and actuators for which it differs from "
           "target.initial")
      .key("own", &MeasuredFile::own, list_of(text()),
           "addresses of values that are unknown and of this file alone, as in [\"body.load.mass\"]: each is fitted to "
           "this file's trials within the bounds of model.free")
      .check({"role", "holdout"},
             [](const TomlNode& node, Reading& reading, MeasuredFile& file) {
               if (file.held_out && !file.holdout.empty())
                 reading.problem_at("holdout", node.find("holdout")->location,
                                    "the whole file is held out already; leave out role or holdout");
             })
      .check({}, [](const TomlNode&, Reading& reading, MeasuredFile& file) { file.key = reading.path(); })
      .located(&MeasuredFile::location);
}

Value<char> delimiter() { return choice<char>({{"auto", '\0'}, {",", ','}, {";", ';'}, {"\t", '\t'}, {" ", ' '}}); }

void check_trials(const TomlNode& node, Reading& reading, RecordingSource& source) {
  if (source.holdout_trials.empty() || !source.trial_column.empty()) return;
  reading.problem_at("holdout_trials", node.find("holdout_trials")->location,
                     "needs trial_column, which tells the trials apart");
}

}  // namespace

Table<RecordingSource> recording_keys() {
  return Table<RecordingSource>()
      .key<std::vector<MeasuredFile>>("files", measured_files(false, 1), {}, append_files,
                                      "recorded: measured files to fit to; required")
      .key<std::vector<MeasuredFile>>(
          "holdout", measured_files(true, 0), {}, append_files,
          "recorded: files kept from every fit; only compare and history read them. Without "
          "it, the last quarter of a trial that is the only one is kept from every fit")
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
      .key("sensors", &RecordingSource::sensors, columns("SENSOR", sensor_column_keys()),
           "What was measured: each table is named like the robot's sensor (its channel) that reads the same.")
      .key("commands", &RecordingSource::commands, columns("ACTUATOR", command_column_keys()),
           "What was applied: each table is named like the robot's actuator that gets the command.")
      .key("controllers", &RecordingSource::controllers, controllers(),
           "What made the commands, where a controller did: each table is named like the actuator. `lacuna diagnose` "
           "then also fits with the controller in the loop, and says where the feedback biases what is identified.")
      .key("drive", &RecordingSource::by_controllers, choice<bool>({{"commands", false}, {"controllers", true}}),
           "what drives models: the recorded commands (open loop) or the controllers (closed loop), which correct the "
           "model's motion as they corrected the rig's")
      .key("initial", &RecordingSource::initial, map_of("JOINT_OR_ACTUATOR", initial_keys().value()),
           "What is known at the start of each trial: of a joint its position and velocity (joints not named here are "
           "taken from the data), of an actuator what it was commanded before.")
      .check({"holdout_trials", "trial_column"}, check_trials)
      .check({"files", "holdout", "recording"}, name_setups)
      .check({}, look_for_holdout)
      .check({"drive", "controllers", "commands"}, check_drive);
}

}  // namespace lacuna
