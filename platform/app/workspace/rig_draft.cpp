#include "app/workspace/rig_draft.h"

#include "app/workspace/controller_draft.h"
#include "app/workspace/draft_text.h"
#include "app/workspace/target_draft.h"
#include "config/toml/toml_node.h"
#include "fitting/starts/restarts.h"
#include "foundation/text/counted.h"
#include "foundation/text/plain_text.h"
#include "foundation/text/shell_word.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kLongestStep = 1e-2;   // s; where a model needs finer steps, they are cut into substeps
constexpr double kFitHorizon = 2.0;     // s
constexpr double kLongRecording = 6.0;  // s

/// The largest size of a channel, 0 where it is not there.
double largest(const TimeSeries& series, const std::string& channel) {
  double size = 0.0;
  for (std::size_t c = 0; c < series.channels.size(); ++c)
    if (series.channels[c].name == channel)
      for (const double value : series.samples.col(static_cast<Eigen::Index>(c)))
        if (std::isfinite(value)) size = std::max(size, std::abs(value));
  return size;
}

/// Bounds about a value of the robot: half of it to twice as much, or, where that is 0, up to what is `usual`.
std::string bounds_about(double value, double usual, const std::string& unit) {
  const double lower = value > 0.0 ? 0.5 * value : 0.0, upper = value > 0.0 ? 2.0 * value : usual;
  if (unit.empty()) return fmt::format("[{:.3g}, {:.3g}]", lower, upper);
  return fmt::format("[\"{:.3g} {}\", \"{:.3g} {}\"]", lower, unit, upper, unit);
}

/// The largest command that was logged over the largest velocity, of a joint: what damping cannot exceed.
double usual_damping(const RigDraft& draft, const RobotSpec& robot, const JointSpec& joint) {
  constexpr double kUnknown = 1.0;  // N*m*s/rad or N*s/m
  if (!draft.recording) return kUnknown;
  double force = 0.0, speed = 0.0;
  for (const Trial& trial : draft.recording->trials) {
    for (const ActuatorSpec& actuator : robot.actuators)
      if (actuator.joint == joint.name && actuator.kind == ActuatorKind::force)
        force = std::max(force, largest(trial.commands.series, actuator.name));
    for (const SensorSpec& sensor : robot.sensors)
      if (sensor.element == joint.name && sensor.kind == SensorKind::joint_velocity)
        speed = std::max(speed, largest(trial.measured, sensor.name));
  }
  return force > 0.0 && speed > 0.0 ? force / speed : kUnknown;
}

/// Gains of servos that the recordings show and the robot file does not have are not known at all.
std::string free_gains(const RigDraft& draft, const RobotSpec& robot) {
  std::string text;
  if (!draft.drive || *draft.drive == ActuatorKind::force) return text;
  for (const ActuatorSpec& actuator : robot.actuators)
    for (const auto& [key, value] : {std::pair("kp", actuator.kp), std::pair("kd", actuator.kd)})
      if (value > 0.0)
        text += fmt::format("\"actuator.{}.{}\" = [{:.3g}, {:.3g}]\n", actuator.name, key, 0.02 * value, 50.0 * value);
  return text;
}

/// Values of the model that a user may want to free, as examples; of a known robot, about its own values.
std::string free_text(const RigDraft& draft) {
  const RobotSpec robot = robot_of(draft);
  std::string text = "\n[model.free]                            # values that the fit may change, and their bounds\n";
  text += free_gains(draft, robot);
  const auto moved = std::ranges::find_if(robot.bodies, [](const BodySpec& body) { return body.mass > 0.0; });
  if (moved != robot.bodies.end())
    text += fmt::format("# \"body.{}.mass\" = {}\n", moved->name,
                        bounds_about(draft.known_robot ? moved->mass : 1.0, 1.0, "kg"));
  const auto turns =
      std::ranges::find_if(robot.joints, [](const JointSpec& joint) { return joint.kind != JointKind::fixed; });
  if (turns != robot.joints.end())
    text += fmt::format("# \"joint.{}.damping\" = {}\n", turns->name,
                        bounds_about(turns->damping, usual_damping(draft, robot, *turns), ""));
  return text;
}

/// What was commanded, where the robot file says something else.
std::string drive_text(const RigDraft& draft) {
  if (!draft.drive) return "";
  const bool is_force = *draft.drive == ActuatorKind::force, is_position = *draft.drive == ActuatorKind::position_servo;
  return with_comment(
      fmt::format("actuator_kinds = {{ \"actuator.*\" = \"{}\" }}", is_force      ? "force"
                                                                    : is_position ? "position_servo"
                                                                                  : "velocity_servo"),
      is_force ? "guessed: torques were logged, no goals" : "guessed: goals were logged, no torques; fit the gains");
}

/// Errors of whole recordings add up; of long ones a part tells values better.
std::string fit_text(const RigDraft& draft) {
  const RobotSpec robot = robot_of(draft);
  if (draft.recording && std::isfinite(restart_interval(robot, draft.recording->trials.front()))) return "";
  if (draft.shortest < kLongRecording) return "";
  return "\n[fit]\n" + with_comment(fmt::format("horizon = \"{:g} s\"", kFitHorizon),
                                    "length of the fitted predictions; \"whole\": whole recordings");
}

}  // namespace

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
      "# {0}: which physical effect is the model missing?\n#\n"
      "# Drafted from {1}. Put a value at each {2}, here and in the robot file, and correct wrong guesses;\n"
      "# `lacuna check` lists the rest. Then: lacuna compare {3}\n\n"
      "[experiment]\nname = {4}\nseed = 1\n\n",
      name, counted(draft.files.size(), "recording"), kBlank,
      plain_text(shell_word(draft.experiment.filename().string())), toml_text(name));
  text += target_text(draft) + controllers_text(draft);
  text += fmt::format("\n[model]\nfile = {}\neffects = []\n{}{}{}\n[engine]\n",
                      toml_text(path_in_file(draft.robot, draft.experiment)), drive_text(draft), free_text(draft),
                      fit_text(draft));
  const std::string value = fmt::format("step = \"{:.4g} ms\"", 1e3 * step);
  return text + (draft.interval > 0.0
                     ? with_comment(value, fmt::format("the recordings' interval is {:.4g} ms", 1e3 * draft.interval))
                     : value + "\n");
}

}  // namespace lacuna
