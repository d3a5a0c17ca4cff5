#include "evaluation/model/robot_values.h"

#include "config/toml/locations.h"
#include "foundation/address.h"
#include "foundation/unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace lacuna {
namespace {

constexpr double kBoundRounding = 1e-9;  ///< of the larger bound
constexpr int kBoundDigits = 6;          ///< digits that show the difference between a value and its bound

/// `body.torso.mass` → `body.*.mass`; `contact.friction` stays.
std::string with_star(const std::string& address) {
  const std::size_t first = address.find('.');
  const std::size_t second = address.find('.', first + 1);
  return second == std::string::npos || address.starts_with("world.")
             ? address
             : address.substr(0, first) + ".*" + address.substr(second);
}

std::string matches_nothing(const std::string& pattern, const std::vector<AddressedValue>& values) {
  std::set<std::string> shapes;
  std::vector<std::string> candidates;
  for (const AddressedValue& value : values) {
    candidates.push_back(value.address);
    shapes.insert(with_star(value.address));
  }
  candidates.insert(candidates.end(), shapes.begin(), shapes.end());
  const std::string kind = pattern.substr(0, pattern.find('.') + 1);
  std::string alike;
  for (const std::string& shape : shapes)
    if (!kind.empty() && shape.starts_with(kind)) alike += (alike.empty() ? "; there is " : ", ") + shape;
  return "matches no value of the robot" + did_you_mean(pattern, candidates) + alike;
}

/// For each value the most specific pattern that matches it, if any.
std::vector<std::optional<std::size_t>> closest_patterns(const std::vector<AddressedValue>& values,
                                                         const std::vector<std::string>& patterns,
                                                         const std::string& table, Complaints& complaints) {
  const auto stars = [&](std::size_t i) { return std::count(patterns[i].begin(), patterns[i].end(), '*'); };
  std::vector<std::optional<std::size_t>> closest(values.size());
  for (std::size_t pattern = 0; pattern < patterns.size(); ++pattern) {
    bool found = false;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!matches(patterns[pattern], values[i].address)) continue;
      found = true;
      if (closest[i] && stars(*closest[i]) == stars(pattern))
        complaints.add(table + patterns[pattern],
                       "and \"" + patterns[*closest[i]] + "\" both mean " + values[i].address + "; keep one of them");
      if (!closest[i] || stars(pattern) < stars(*closest[i])) closest[i] = pattern;
    }
    if (!found) complaints.add(table + patterns[pattern], matches_nothing(patterns[pattern], values));
  }
  return closest;
}

std::string bounds_text(const AddressedValue& value) {
  return format_quantity(value.lower, value.unit) + " to " + format_quantity(value.upper, value.unit);
}

void scale_inertia(InertiaSpec& inertia, double factor) {
  for (double* moment : {&inertia.xx, &inertia.yy, &inertia.zz, &inertia.xy, &inertia.xz, &inertia.yz})
    *moment *= factor;
}

/// Bounds and value may be written in different units, "800 g" and 0.8, which differ in their last digits.
bool is_within(double value, const FreeRange& range) {
  const double rounding = kBoundRounding * std::max(std::abs(range.lower), std::abs(range.upper));
  return value >= range.lower - rounding && value <= range.upper + rounding;
}

/// The place in the robot file that gives this value, if any: its key, that of its vector, or the body whose shapes
/// determine its mass and inertia.
std::optional<SourceLocation> place_in_robot_file(const ModelSection& section, const std::string& address) {
  if (!section.declared) return std::nullopt;
  if (address.starts_with("body.")) return nearest_location(section.robot_places, address, section.file.string());
  const std::string key = address.starts_with("world.gravity") ? "robot.gravity" : address;
  const bool is_component = std::count(key.begin(), key.end(), '.') > 2;
  const auto found = section.robot_places.find(is_component ? key.substr(0, key.rfind('.')) : key);
  return found == section.robot_places.end() ? std::nullopt : std::optional(found->second);
}

/// The pattern of `[model.set]` that set the value, if any: the most specific.
std::optional<std::string> set_by(const ModelSection& section, const std::string& address) {
  const auto stars = [](const std::string& pattern) { return std::count(pattern.begin(), pattern.end(), '*'); };
  std::optional<std::string> closest;
  for (const auto& [pattern, value] : section.set)
    if (matches(pattern, address) && (!closest || stars(pattern) < stars(*closest))) closest = pattern;
  return closest;
}

/// Moves a value that no file gives to its bounds, and complains of a file's value outside them: the fit would start
/// from another model than the files describe.
FreeValue free_value(const AddressedValue& value, const FreeRange& range, const SystemSource& source,
                     Complaints& complaints) {
  const double start = range.start.value_or(*value.value);
  FreeValue free{{.address = value.address,
                  .unit = value.unit,
                  .lower = range.lower,
                  .upper = range.upper,
                  .start = std::clamp(start, range.lower, range.upper)}};
  if (source.free != "free" || is_within(start, range)) return free;
  const std::string bounds = source.key + "." + source.free + "." + range.pattern;
  const std::string beyond = fmt::format(
      "{} lies outside {} to {}, the bounds that {} has at {}; write a value within these bounds, widen them, or set "
      "the start of the fit there: {{ range = [{}, {}], start = ... }}",
      format_quantity(start, value.unit, kBoundDigits), format_quantity(range.lower, value.unit, kBoundDigits),
      format_quantity(range.upper, value.unit, kBoundDigits), bounds, to_string(complaints.where(bounds)), range.lower,
      range.upper);
  if (const std::optional<std::string> pattern = set_by(source.section, value.address))
    complaints.add(source.key + ".set." + *pattern, beyond);
  else if (const std::optional<SourceLocation> place = place_in_robot_file(source.section, value.address))
    complaints.add_at(*place, value.address + ": " + beyond);
  else
    free.own = start;
  return free;
}

}  // namespace

void assign_value(RobotSpec& robot, const AddressedValue& target, double value) {
  for (BodySpec& body : robot.bodies)
    if (target.value == &body.mass && body.inertia_scales_with_mass) scale_inertia(body.inertia, value / body.mass);
  *target.value = value;
}

void set_robot_values(RobotSpec& robot, const SystemSource& source, Complaints& complaints) {
  const std::vector<AddressedValue> values = addressed_values(robot);
  std::vector<std::string> patterns;
  for (const auto& [pattern, value] : source.section.set) patterns.push_back(pattern);
  const auto closest = closest_patterns(values, patterns, source.key + ".set.", complaints);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!closest[i]) continue;
    const std::string& pattern = patterns[*closest[i]];
    const double value = source.section.set.at(pattern);
    complaints.check_unit(source.key + ".set." + pattern, values[i].unit);
    if (value >= values[i].lower && value <= values[i].upper)
      assign_value(robot, values[i], value);
    else
      complaints.add(source.key + ".set." + pattern, format_quantity(value, values[i].unit) +
                                                         " is not a possible value of " + values[i].address + " (" +
                                                         bounds_text(values[i]) + ")");
  }
}

std::vector<FreeValue> free_robot_values(RobotSpec& robot, const SystemSource& source, Complaints& complaints) {
  const std::vector<AddressedValue> values = addressed_values(robot);
  const std::string table = source.key + "." + source.free + ".";
  const std::vector<FreeRange>& ranges = source.section.free;
  std::vector<std::string> patterns;
  patterns.reserve(ranges.size());
  for (const FreeRange& range : ranges) patterns.push_back(range.pattern);
  const auto closest = closest_patterns(values, patterns, table, complaints);
  std::vector<FreeValue> free;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!closest[i]) continue;
    const FreeRange& range = ranges[*closest[i]];
    for (const char* number : {"[0]", "[1]", ".range[0]", ".range[1]", ".uniform[0]", ".uniform[1]", ".start"})
      complaints.check_unit(table + range.pattern + number, values[i].unit);
    if (range.lower >= values[i].lower && range.lower <= range.upper && range.upper <= values[i].upper)
      free.push_back(free_value(values[i], range, source, complaints));
    else
      complaints.add(table + range.pattern, "the range exceeds the possible values of " + values[i].address + " (" +
                                                bounds_text(values[i]) + ")");
  }
  return free;
}

void set_sensor_noise(RobotSpec& robot, const std::map<std::string, double>& noise, Complaints& complaints) {
  std::vector<AddressedValue> values;
  for (AddressedValue& value : addressed_values(robot))
    if (matches("sensor.*.noise", value.address)) values.push_back(std::move(value));
  std::vector<std::string> patterns;
  for (const auto& [pattern, deviation] : noise) patterns.push_back(pattern + ".noise");
  const auto closest = closest_patterns(values, patterns, "target.noise.", complaints);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!closest[i]) continue;
    const std::string& pattern = patterns[*closest[i]];
    const std::string written = pattern.substr(0, pattern.rfind('.'));
    complaints.check_unit("target.noise." + written, values[i].unit);
    *values[i].value = noise.at(written);
  }
}

}  // namespace lacuna
