#include "foundation/placement_unit.h"

#include "foundation/address.h"
#include "foundation/unit.h"

#include <algorithm>
#include <map>
#include <string_view>

namespace lacuna {
namespace {

using Words = std::map<std::string, std::string>;

Words joint_words(bool slider) {
  return slider ? Words{{"{position}", "m"}, {"{force}", "N"}, {"{inertia}", "kg"}}
                : Words{{"{position}", "rad"}, {"{force}", "N*m"}, {"{inertia}", "kg*m^2"}};
}

bool is_slider(const RobotSpec& robot, const std::string& joint) {
  return std::any_of(robot.joints.begin(), robot.joints.end(), [&](const JointSpec& candidate) {
    return candidate.name == joint && candidate.kind == JointKind::slider;
  });
}

/// A product in a denominator is kept together.
std::string in_place(const std::string& unit, char before) {
  return before == '/' && unit.find_first_of("*/") != unit.npos ? "(" + unit + ")" : unit;
}

std::string replaced(std::string text, const Words& words) {
  for (const auto& [word, unit] : words)
    for (std::size_t at = text.find(word); at != text.npos; at = text.find(word))
      text.replace(at, word.size(), in_place(unit, at > 0 ? text[at - 1] : ' '));
  return text;
}

}  // namespace

std::string unit_at(const std::string& declared, const RobotSpec& robot, ElementKind kind, int element) {
  const auto index = static_cast<std::size_t>(element);
  switch (kind) {
    case ElementKind::joint: return replaced(declared, joint_words(robot.joints[index].kind == JointKind::slider));
    case ElementKind::actuator: {  // an effect acts after the gain
      ActuatorSpec actuator = robot.actuators[index];
      actuator.relative = false;
      Words words = joint_words(is_slider(robot, actuator.joint));
      words["{command}"] = command_channel(robot, actuator).unit;
      return replaced(declared, words);
    }
    case ElementKind::sensor: {  // and before the scale
      SensorSpec sensor = robot.sensors[index];
      sensor.relative = false;
      Words words = joint_words(is_slider(robot, sensor.element));
      words["{channel}"] = sensor_channels(robot, sensor).front().unit;
      return replaced(declared, words);
    }
    case ElementKind::body:
    case ElementKind::world: break;
  }
  return declared;
}

bool is_unit_on(ElementKind kind, const std::string& declared) {
  const auto is_unit = [&](Words words) {
    if (kind == ElementKind::body || kind == ElementKind::world) words.clear();
    if (kind == ElementKind::actuator) words["{command}"] = "V";
    if (kind == ElementKind::sensor) words["{channel}"] = "m/s^2";
    return parse_unit(replaced(declared, words)).has_value();
  };
  return is_unit(joint_words(false)) && is_unit(joint_words(true));
}

std::string unit_words_on(ElementKind kind) {
  std::string of_joint = "{position}, {force}, {inertia}";
  switch (kind) {
    case ElementKind::joint: return of_joint;
    case ElementKind::actuator: return of_joint + ", {command}";
    case ElementKind::sensor: return of_joint + ", {channel}";
    case ElementKind::body:
    case ElementKind::world: break;
  }
  return {};
}

std::string unit_in_words(const std::string& declared) {
  const Words elsewhere = {{"{command}", "[command]"}, {"{channel}", "[channel]"}};
  const std::string rotation = replaced(replaced(declared, joint_words(false)), elsewhere);
  const std::string translation = replaced(replaced(declared, joint_words(true)), elsewhere);
  if (declared == "{command}") return "the command's unit";
  if (declared == "{channel}") return "the channel's unit";
  return rotation == translation ? rotation : rotation + " (" + translation + " on a slider)";
}

}  // namespace lacuna
