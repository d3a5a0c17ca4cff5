#include "app/workspace/rig_draft.h"

#include "app/workspace/controller_draft.h"
#include "config/toml_node.h"
#include "foundation/counted.h"
#include "foundation/plain_text.h"
#include "foundation/shell_word.h"
#include "foundation/unit.h"
#include "measurement/rest_noise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kLongestStep = 1e-2;   // s; where a model needs finer steps, they are cut into substeps
constexpr double kFitHorizon = 2.0;     // s
constexpr double kLongRecording = 6.0;  // s
constexpr int kCommentColumn = 40;

/// A line with its comment to the right of it. A column's name may be in the comment, and may have line breaks in it.
std::string with_comment(const std::string& line, const std::string& comment) {
  return fmt::format("{:<{}}# {}\n", line + "  ", kCommentColumn, plain_text(comment));
}

/// A path as the experiment names it: from its own folder where the file is not far from it.
std::string path_in_file(const std::filesystem::path& file, const std::filesystem::path& experiment) {
  const std::filesystem::path whole = std::filesystem::absolute(file).lexically_normal();
  const std::filesystem::path folder = std::filesystem::absolute(experiment).lexically_normal().parent_path();
  const std::string near = whole.lexically_proximate(folder).string();
  return near.starts_with("../../") ? whole.string() : near;
}

bool has_dimension(const std::string& unit, const std::string& of) {
  const std::optional<Unit> a = parse_unit(unit), b = parse_unit(of);
  return a && b && a->same_dimension(*b);
}

/// What the recordings tell about a sensor's noise: the key, and the reason for the comment.
struct NoiseText {
  std::string key;
  std::string reason;
};

NoiseText noise_of(const RigDraft& draft, const std::string& channel, const std::string& unit,
                   const std::string& column_unit) {
  if (!draft.recording) return {};
  std::vector<Trial> fit;
  for (const Trial& trial : draft.recording->trials)
    if (!trial.held_out) fit.push_back(trial);
  const SensorNoise noise = estimate_sensor_noise(fit, channel);
  if (!(noise.standard_deviation > 0.0)) return {"", "noise " + noise.origin(unit)};
  const double written = noise.standard_deviation / parse_unit(column_unit)->to_si;
  return {fmt::format(", noise = \"{:.3g} {}\"", written, column_unit), "noise: " + noise.origin(unit)};
}

std::string unit_or_blank(const GuessedColumn& column, const std::string& si_unit) {
  return has_dimension(column.unit, si_unit) ? toml_text(column.unit) : blank("");
}

std::string sensor_line(const RigDraft& draft, const MatchedColumn& match) {
  const auto& [channel, column] = match;
  if (column.of_voltage && !column.unit.empty())
    return with_comment(
        fmt::format("{} = {{ column = {}, unit = {}, gain = {} }}", toml_key(channel.name), toml_text(column.name),
                    toml_text(column.unit), blank(fmt::format("{}/{}", channel.unit, column.unit))),
        "guessed: " + column.reason + "; the gain is the sensor's");
  const bool known = has_dimension(column.unit, channel.unit);
  const NoiseText noise = known ? noise_of(draft, channel.name, channel.unit, column.unit) : NoiseText{};
  const std::string line = fmt::format("{} = {{ column = {}, unit = {}{} }}", toml_key(channel.name),
                                       toml_text(column.name), unit_or_blank(column, channel.unit), noise.key);
  std::string comment = "guessed: " + column.reason;
  if (!known) comment += "; unit as in rad, deg, m, mm, rad/s; of an encoder's counts \"1\" and counts_per_turn = 4096";
  if (!noise.reason.empty()) comment += "; " + noise.reason;
  return with_comment(line, comment);
}

std::string command_text(const MatchedColumn& match) {
  const GuessedColumn& column = match.column;
  const std::string& wanted = match.channel.unit;
  std::string line = fmt::format("{} = {{ column = {}, unit = ", toml_key(match.channel.name), toml_text(column.name));
  std::string comment = "guessed: " + column.reason;
  if (column.unit.empty()) {
    line += blank("") + " }";
    comment += wanted == "V" ? std::string("; unit V or mV")
                             : fmt::format("; unit {}, or another with a gain such as \"2.5 {}/V\"", wanted, wanted);
  } else if (has_dimension(column.unit, wanted)) {
    line += toml_text(column.unit) + " }";
  } else {
    line += fmt::format("{}, gain = {} }}", toml_text(column.unit), blank(wanted + "/" + column.unit));
    comment += fmt::format("; the gain turns {} into {}", column.unit, wanted);
    if (has_dimension(column.unit, "A")) comment += ": the motor's constant, seen at the joint";
    if (has_dimension(column.unit, "V"))
      comment += ", as a drive that controls the current does; for a motor at this voltage make its kind \"voltage\"";
  }
  return with_comment(line, comment);
}

/// A line for each channel of the robot that got no column.
std::string unmatched_text(const RigGuess& guess, bool actuators) {
  std::string text;
  for (const UnmatchedChannel& left : guess.unmatched)
    if (left.is_actuator == actuators)
      text += fmt::format("# not matched: {} in {}, {}\n", left.channel.name, left.channel.unit, reason_of(left));
  return text;
}

std::string file_list(const RigDraft& draft, bool held_out) {
  const std::size_t fit = draft.files.size() - (draft.files.size() > 1 && !draft.guess.trial ? 1 : 0);
  const bool one = (held_out ? draft.files.size() - fit : fit) == 1;
  std::string list;
  for (std::size_t i = held_out ? fit : 0; i < (held_out ? draft.files.size() : fit); ++i)
    list += (one ? "" : "\n  ") + toml_text(path_in_file(draft.files[i], draft.experiment)) + (one ? "" : ",");
  return "[" + list + (one ? "]" : "\n]");
}

/// The last trial's name in a column of trials: `runs.csv[3]` → 3.
std::string last_trial(const RigDraft& draft) {
  if (!draft.recording || draft.recording->trials.size() < 2) return {};
  const std::string& name = draft.recording->trials.back().name;
  const std::size_t open = name.rfind('[');
  return open == name.npos ? "" : name.substr(open + 1, name.size() - open - 2);
}

std::string target_text(const RigDraft& draft) {
  const RigGuess& guess = draft.guess;
  std::string text = "[target]\nkind = \"recorded\"\nfiles = " + file_list(draft, false) + "\n";
  if (guess.trial) {
    text += with_comment("trial_column = " + toml_text(guess.trial->name), "guessed: " + guess.trial->reason);
    if (const std::string last = last_trial(draft); !last.empty())
      text += with_comment("holdout_trials = [" + toml_text(last) + "]", "guessed: the last one; kept from every fit");
  } else if (draft.files.size() > 1) {
    text += with_comment("holdout = " + file_list(draft, true), "guessed: the last file; kept from every fit");
  }
  text += with_comment(guess.hold == Hold::zero_order ? "hold = \"zero\"" : "hold = \"first\"",
                       "guessed: " + guess.hold_reason);
  text += "\n[target.time]\n" +
          with_comment("column = " + toml_text(guess.time.name), "guessed: " + guess.time.reason) +
          with_comment("unit = " + toml_text(guess.time.unit), "guessed: " + guess.time_unit_reason);
  return text;
}

std::string columns_text(const RigDraft& draft) {
  const RigGuess& guess = draft.guess;
  std::string text = "\n[target.sensors]                        # named like the robot's sensors\n";
  for (const MatchedColumn& sensor : guess.sensors) text += sensor_line(draft, sensor);
  text += unmatched_text(guess, false);
  text += "\n[target.commands]                       # named like the robot's actuators\n";
  for (const MatchedColumn& command : guess.commands) text += command_text(command);
  text += unmatched_text(guess, true);
  for (const GuessedColumn& column : guess.unused)
    text += fmt::format("# not used: column {}, {}\n", toml_text(column.name), plain_text(column.reason));
  return text;
}

/// Values of the model that a user may want to free, as examples.
std::string free_text(const RobotSpec& robot) {
  std::string text = "\n[model.free]                            # what the fit may change, and how far\n";
  if (!robot.bodies.empty())
    text += fmt::format("# \"body.{}.mass\" = [\"0.5 kg\", \"2 kg\"]\n", robot.bodies.front().name);
  if (!robot.joints.empty()) text += fmt::format("# \"joint.{}.damping\" = [0.0, 1.0]\n", robot.joints.front().name);
  return text;
}

/// Errors of whole recordings add up; of long ones a part tells values better.
std::string fit_text(const RigDraft& draft) {
  if (draft.shortest < kLongRecording) return "";
  return "\n[fit]\n" + with_comment(fmt::format("horizon = \"{:g} s\"", kFitHorizon),
                                    "of predictions that are fitted; \"whole\": of whole recordings");
}

std::string body_text(const GuessedJoint& joint, bool is_first) {
  std::string text = fmt::format("\n[body.{}]\n", joint.body());
  text += with_comment("mass = " + blank("kg"), "everything that moves with this joint");
  if (joint.slides) {
    text += with_comment("inertia = [1.0, 1.0, 1.0]", "kg*m^2; of no effect while nothing turns");
    return text;
  }
  if (!is_first)
    text += with_comment(fmt::format("at = [0.0, 0.0, {}]", blank("m")), "where the joint is, all joints at zero");
  text += with_comment(fmt::format("com = [0.0, 0.0, {}]", blank("m")),
                       "centre of mass, seen from the joint; negative: hanging");
  const std::string moment = blank("kg*m^2");
  text +=
      with_comment(fmt::format("inertia = [{}, {}, {}]", moment, moment, moment),
                   "about the centre of mass, along x, y, z; a slim rod has m*L^2/12 across and next to nothing along");
  return text;
}

std::string joint_text(const GuessedJoint& joint, const std::string& body_before) {
  std::string text = fmt::format("\n[joint.{}]\n", joint.name);
  text += with_comment(joint.slides ? "kind = \"slider\"" : "kind = \"hinge\"", "guessed: from the columns' units");
  if (!body_before.empty())
    text += with_comment("parent = " + toml_text(std::string(kBlank) + " world or " + body_before),
                         "the body that carries this joint");
  text += "child = " + toml_text(joint.body()) + "\n";
  text += joint.slides ? with_comment("axis = \"x\"", "guessed: horizontal, so that gravity does nothing")
                       : with_comment("axis = \"y\"", "guessed: horizontal; at zero the arm is as com says");
  return text;
}

std::string motor_text(const GuessedJoint& joint) {
  std::string text = fmt::format("\n[actuator.{}]\njoint = {}\n", joint.motor(), toml_text(joint.name));
  const std::string force = joint.slides ? "N" : "N*m";
  if (joint.actuator == ActuatorKind::position_servo) {
    text += with_comment("kind = \"position_servo\"", "guessed: the command is a position");
    text += with_comment("kp = " + blank(force + "/" + position_unit(joint)), "stiffness of the servo");
    text += with_comment("kd = " + blank(force + "*s/" + position_unit(joint)), "its damping");
  } else if (joint.actuator == ActuatorKind::velocity_servo) {
    text += with_comment("kind = \"velocity_servo\"", "guessed: the command is a velocity");
    text += with_comment("kd = " + blank(force + "*s/" + position_unit(joint)), "gain of the servo");
  } else if (joint.actuator == ActuatorKind::voltage) {
    text += with_comment("kind = \"voltage\"",
                         fmt::format("guessed: the voltage of a motor; if a drive makes a {0} of it, kind = \"force\" "
                                     "here and a gain in {1}/V in the experiment",
                                     joint.slides ? "force" : "torque", force));
    text += fmt::format("\n[actuator.{}.motor]\n", joint.motor());
    text += with_comment("torque_constant = " + blank(force + "/A"), "at the joint");
    text += with_comment("resistance = " + blank("Ohm"), "of the winding and its driver");
  } else {
    text += with_comment("kind = \"force\"", "the command is a " + std::string(joint.slides ? "force" : "torque"));
  }
  return text;
}

std::string sensor_text(const GuessedJoint& joint) {
  const auto sensor = [&](const std::string& name, const char* kind) {
    return fmt::format("\n[sensor.{}]\nkind = \"{}\"\njoint = {}\n", name, kind, toml_text(joint.name));
  };
  std::string text;
  if (joint.position) text += sensor(joint.position_sensor(), "joint_position");
  if (joint.velocity) text += sensor(joint.velocity_sensor(), "joint_velocity");
  return text;
}

}  // namespace

std::string blank(const std::string& unit) {
  return toml_text(unit.empty() ? std::string(kBlank) : kBlank + (" " + unit));
}

std::string reason_of(const UnmatchedChannel& left) {
  if (left.candidates.empty()) return "no column fits";
  std::string columns;
  for (const std::string& name : left.candidates) columns += (columns.empty() ? "" : ", ") + name;
  return (left.candidates.size() > 1 ? "several columns fit: " : "a column fits others as well: ") + columns;
}

RobotSpec robot_of(const RigDraft& draft) {
  return draft.known_robot ? *draft.known_robot : placeholder_robot(draft.guess);
}

std::string rig_name(const std::filesystem::path& experiment) {
  std::string name;
  for (const char c : experiment.stem().string())
    name += std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-' ? c : '-';
  return name.empty() ? "rig" : name;
}

double step_for(double interval) {
  if (!(interval > 0.0)) return 1e-3;
  return interval / std::ceil(interval / kLongestStep * (1.0 - 1e-6));
}

std::string experiment_text(const RigDraft& draft) {
  const std::string name = rig_name(draft.experiment);
  const double step = step_for(draft.interval);
  std::string text = fmt::format(
      "# What is {0} a model of, and what does the model lack?\n#\n"
      "# Drafted from {1}. Put values where it says {2}, here and in the robot file, and mend what was\n"
      "# guessed wrong; `lacuna check` says what is left. Then: lacuna compare {3}\n\n"
      "[experiment]\nname = {4}\nseed = 1\n\n",
      name, counted(draft.files.size(), "recording"), kBlank,
      plain_text(shell_word(draft.experiment.filename().string())), toml_text(name));
  text += target_text(draft) + columns_text(draft) + controllers_text(draft);
  text +=
      fmt::format("\n[model]\nfile = {}\neffects = []\n{}{}\n[engine]\n",
                  toml_text(path_in_file(draft.robot, draft.experiment)), free_text(robot_of(draft)), fit_text(draft));
  const std::string value = fmt::format("step = \"{:.4g} ms\"", 1e3 * step);
  return text + (draft.interval > 0.0
                     ? with_comment(value, fmt::format("the recordings' interval is {:.4g} ms", 1e3 * draft.interval))
                     : value + "\n");
}

std::string robot_text(const RigDraft& draft) {
  const std::string name = rig_name(draft.experiment);
  std::string text = fmt::format(
      "# The robot of {}: one body a joint. Put values where it says {}; SI units, z up.\n"
      "# What is not written here (friction, a spring, the rotor's inertia) is zero.\n\n[robot]\nname = {}\n",
      plain_text(draft.experiment.filename().string()), kBlank, toml_text(name));
  const std::vector<GuessedJoint>& joints = draft.guess.joints;
  for (std::size_t i = 0; i < joints.size(); ++i) text += body_text(joints[i], i == 0);
  for (std::size_t i = 0; i < joints.size(); ++i) text += joint_text(joints[i], i > 0 ? joints[i - 1].body() : "");
  for (const GuessedJoint& joint : joints)
    if (joint.command) text += motor_text(joint);
  for (const GuessedJoint& joint : joints) text += sensor_text(joint);
  return text;
}

RobotSpec placeholder_robot(const RigGuess& guess) {
  RobotSpec robot;
  for (const GuessedJoint& joint : guess.joints) {
    BodySpec body;
    body.name = joint.body();
    robot.bodies.push_back(body);
    JointSpec spec;
    spec.name = joint.name;
    spec.kind = joint.slides ? JointKind::slider : JointKind::hinge;
    spec.child = joint.body();
    robot.joints.push_back(spec);
    if (joint.command) {
      ActuatorSpec motor;
      motor.name = joint.motor();
      motor.joint = joint.name;
      motor.kind = joint.actuator;
      robot.actuators.push_back(motor);
    }
    const auto add_sensor = [&](const std::string& name, SensorKind kind) {
      SensorSpec sensor;
      sensor.name = name;
      sensor.kind = kind;
      sensor.element = joint.name;
      robot.sensors.push_back(sensor);
    };
    if (joint.position) add_sensor(joint.position_sensor(), SensorKind::joint_position);
    if (joint.velocity) add_sensor(joint.velocity_sensor(), SensorKind::joint_velocity);
  }
  return robot;
}

}  // namespace lacuna
