#include "config/schema/column_schema.h"

#include "config/schema/blank.h"
#include "foundation/unit.h"

#include <cmath>

namespace lacuna {
namespace {

constexpr double kTurn = 2.0 * M_PI;  // rad

/// The unit of a column as written; the reader of the column decides the conversion.
Value<std::string> unit_name() {
  Value<std::string> value = text();
  value.shape.meaning = "a unit such as deg, mm, N*m";
  value.read = [plain = text()](const TomlNode& node, Reading& reading, std::string& result) {
    if (!plain.read(node, reading, result)) return false;
    if (parse_unit(result)) return true;
    reading.problem(node, is_blank(result) ? blank_complaint(result, "")
                                           : toml_text(result) + " is not a unit; known units are " + known_units());
    return false;
  };
  return value;
}

}  // namespace

Value<std::string> time_unit() {
  Value<std::string> value = unit_name();
  value.shape.meaning = "a unit of time such as s, ms";
  value.read = [unit = unit_name()](const TomlNode& node, Reading& reading, std::string& result) {
    if (!unit.read(node, reading, result)) return false;
    if (parse_unit(result)->same_dimension(*parse_unit("s"))) return true;
    reading.problem(node, toml_text(result) + " is not a unit of time; write s, ms, us or min");
    return false;
  };
  return value;
}

namespace {

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
    reading.problem(node, "the gain must not be zero");
    return false;
  };
  value.write = [](const Gain& shown) { return toml_number(shown.value); };
  return value;
}

}  // namespace

Value<Encoding> encoding() {
  Value<Encoding> value;
  value.shape.kind = Shape::Kind::text;
  value.shape.meaning = "\"auto\", \"plain\", or sign_bit, twos_complement or wraps with a number such as 2^15";
  value.read = [plain = text()](const TomlNode& node, Reading& reading, Encoding& result) {
    std::string written;
    if (!plain.read(node, reading, written)) return false;
    const std::optional<Encoding> parsed = parse_encoding(written);
    if (parsed) result = *parsed;
    if (!parsed)
      reading.problem(node, toml_text(written) +
                                " is not an encoding; write \"plain\", \"sign_bit 2^15\", "
                                "\"twos_complement 2^16\" or \"wraps 2^16\"");
    return parsed.has_value();
  };
  value.write = [](const Encoding& shown) { return toml_text(to_string(shown)); };
  return value;
}

namespace {

Table<ColumnMapping> column_keys() {
  return Table<ColumnMapping>()
      .required("column", &ColumnMapping::column, text(), "the column's name in the file's header")
      .required("unit", &ColumnMapping::unit, unit_name(), "unit of the column; \"1\" for a plain number")
      .key<Gain>(
          "gain", gain(), {},
          [](ColumnMapping& mapping, Gain&& read) {
            mapping.gain = read.value;
            mapping.gain_unit = read.unit;
          },
          "factor from the column to the channel, as in \"35.15065 N/V\"")
      .key<double>(
          "counts_per_turn", mapped<double, double>(number("1").above(0.0), [](double&& read) { return read; }), {},
          [](ColumnMapping& mapping, double&& read) {
            mapping.gain = kTurn / read;
            mapping.gain_unit = "rad";
          },
          "instead of gain: the column (unit = \"1\") counts, with this many counts per turn")
      .check({"gain", "counts_per_turn"},
             [](const TomlNode& node, Reading& reading, ColumnMapping& mapping) {
               const TomlNode* counts = node.find("counts_per_turn");
               if (counts && mapping.unit != "1")
                 reading.problem_at("counts_per_turn", counts->location,
                                    "the column contains counts: write unit = \"1\", not \"" + mapping.unit +
                                        "\", or leave out counts_per_turn");
               if (counts && node.find("gain"))
                 reading.problem_at("counts_per_turn", counts->location,
                                    "gain and counts_per_turn exclude each other; keep one of them");
             })
      .key("offset", &ColumnMapping::offset, number(""), "added after the gain, in the channel's unit")
      .key("encoding", &ColumnMapping::encoding, encoding(),
           "how the device wrote the numbers. plain: as they are; sign_bit 2^15: from 2^15 on, minus the excess over "
           "it; twos_complement 2^16: in the upper half, minus 2^16; wraps 360: a count that restarts at 360; auto: "
           "recognised from the column")
      .key("noise", &ColumnMapping::noise, number("").at_least(0.0),
           "standard deviation of the measurement, in the channel's unit")
      .located(&ColumnMapping::location);
}

enum class Kept { glitches, repeats };

Value<std::array<double, 2>> point_of_track() {
  return mapped<std::array<double, 2>, std::vector<double>>(list_of(number("m")), [](std::vector<double>&& read) {
    read.resize(2);
    return std::array<double, 2>{read[0], read[1]};
  });
}

/// x and y of a tracked point.
Table<ColumnMapping> track_keys() {
  return column_keys()
      .key<std::string>(
          "y", text(), {}, [](ColumnMapping& mapping, std::string&& read) { mapping.track.other = std::move(read); },
          "the column is x of a point tracked in a video, and this is the column of y, in the same unit: for an angle "
          "sensor they give the direction of the point from pivot, from x towards y; of a "
          "sensor "
          "of a length its distance from there")
      .key<std::array<double, 2>>(
          "pivot", point_of_track(), {{0.0, 0.0}},
          [](ColumnMapping& mapping, std::array<double, 2>&& read) { mapping.track.pivot = read; },
          "with y: x and y of the joint")
      .key<double>(
          "zero", number("rad"), 0.0, [](ColumnMapping& mapping, double&& read) { mapping.track.zero = read; },
          "with y: direction of angle zero, from x towards y; \"-90 deg\": hanging down, with y up")
      .check({"pivot", "zero"}, [](const TomlNode& node, Reading& reading, ColumnMapping& mapping) {
        if (const TomlNode* pivot = node.find("pivot"); pivot && pivot->items.size() != 2)
          reading.problem_at("pivot", pivot->location, "must be x and y of the joint, as in [\"0.1 m\", \"0.42 m\"]");
        for (const char* key : {"pivot", "zero"})
          if (const TomlNode* one = node.find(key); one && mapping.track.other.empty())
            reading.problem_at(key, one->location, "needs y, the column of the point's second coordinate");
      });
}

Table<ColumnMapping> sensor_column_keys() {
  return track_keys().key<std::vector<Kept>>(
      "keep", list_of(choice<Kept>({{"glitches", Kept::glitches}, {"repeats", Kept::repeats}})), {},
      [](ColumnMapping& mapping, std::vector<Kept>&& kept) {
        for (const Kept one : kept) (one == Kept::glitches ? mapping.keeps_glitches : mapping.keeps_repeats) = true;
      },
      "values that are compared although they look like missing readings");
}

Table<ColumnMapping> command_column_keys() {
  return column_keys()
      .key("derivative", &ColumnMapping::derivative, boolean(),
           "the command is the derivative of the column, by central differences: for a recorded position, the imposed "
           "velocity")
      .key("enabled_by", &ColumnMapping::enabled_by, text(0),
           "a column that is 0 while the actuator is off and exerts no force");
}

Value<std::vector<ColumnMapping>> columns(const std::string& name_hint, const Table<ColumnMapping>& keys) {
  return named<std::vector<ColumnMapping>, ColumnMapping>(
      name_hint, keys.value(),
      [](std::vector<ColumnMapping>& mappings, const TomlMember& member, ColumnMapping&& mapping) {
        mapping.channel = member.name;
        mappings.push_back(std::move(mapping));
      });
}

}  // namespace

Value<std::vector<ColumnMapping>> sensor_columns() { return columns("SENSOR", sensor_column_keys()); }
Value<std::vector<ColumnMapping>> command_columns() { return columns("ACTUATOR", command_column_keys()); }

namespace {

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
      .required("unit", &ColumnMapping::unit, unit_name(), "unit of the column")
      .located(&ColumnMapping::location);
}

Table<ControllerMapping> controller_keys() {
  return Table<ControllerMapping>()
      .required("reads", &ControllerMapping::sensor, text(), "sensor (its channel) that is fed back")
      .required("reference", &ControllerMapping::reference, reference_keys().value(),
                "column with the set point of the sensor, as in { column = \"wanted\", unit = \"rad\" }")
      .key<Gain>("proportional", gain(), {},
                 set_gain(&ControllerMapping::proportional, &ControllerMapping::proportional_unit),
                 "proportional gain: command per control error, as in \"8 N*m/rad\"")
      .key<Gain>("derivative", gain(), {},
                 set_gain(&ControllerMapping::derivative, &ControllerMapping::derivative_unit),
                 "derivative gain, on the reading's change from sample to sample, as in \"0.2 N*m*s/rad\"")
      .key<Gain>("integral", gain(), {}, set_gain(&ControllerMapping::integral, &ControllerMapping::integral_unit),
                 "integral gain: command per integral of the control error, as in \"2 N*m/(rad*s)\"")
      .key("limit", &ControllerMapping::limit, number("").above(0.0).or_infinite(),
           "the command is limited to ± this value, in the unit of the command")
      .key("filter", &ControllerMapping::filter, number("s").at_least(0.0),
           "time constant of a first-order low-pass before the derivative; 0: none")
      .located(&ControllerMapping::location);
}

}  // namespace

Value<std::vector<ControllerMapping>> controllers() {
  return named<std::vector<ControllerMapping>, ControllerMapping>(
      "ACTUATOR", controller_keys().value(),
      [](std::vector<ControllerMapping>& mappings, const TomlMember& member, ControllerMapping&& mapping) {
        mapping.actuator = mapping.reference.channel = member.name;
        mappings.push_back(std::move(mapping));
      });
}

}  // namespace lacuna
