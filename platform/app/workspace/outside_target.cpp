#include "app/workspace/outside_target.h"

#include "evaluation/prediction/test_space.h"
#include "fitting/starts/start_states.h"
#include "foundation/text/unit_text.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace lacuna {
namespace {

/// The joint of each coordinate; empty where a body floats or a joint has several.
std::vector<std::string> single_coordinates(const RobotSpec& robot) {
  std::vector<std::string> joints;
  for (const JointSpec& joint : robot.joints) {
    if (joint.kind == JointKind::hinge || joint.kind == JointKind::slider) joints.push_back(joint.name);
    if (joint.kind == JointKind::ball || joint.kind == JointKind::universal || joint.kind == JointKind::free) return {};
  }
  return has_floating_body(robot) ? std::vector<std::string>() : joints;
}

}  // namespace

std::unique_ptr<ProcessTarget> outside_target(const Experiment& experiment, const ModelDefinition& model,
                                              std::uint64_t noise_seed, const Stop& stop, TargetNotes notes) {
  if (experiment.target.kind != "process") return nullptr;
  const RobotSpec& robot = model.structure.robot;
  return std::make_unique<ProcessTarget>(
      ProcessTargetSetting{.source = experiment.target.process,
                           .location = experiment.where("target.command"),
                           .space = test_space(robot, experiment.engine, experiment.test.duration),
                           .coordinates = single_coordinates(robot),
                           .noise_seed = noise_seed,
                           .note = std::move(notes),
                           .stop = stop});
}

std::string target_summary(const Hello& hello) {
  constexpr const char *kSeries = "whole command series (series)", *kExchange = "one command per reading (exchange)";
  std::string text =
      fmt::format("process \"{}\": accepts {}{}{}", hello.name, hello.takes_series ? kSeries : "",
                  hello.takes_series && hello.exchanges ? " and " : "", hello.exchanges ? kExchange : "");
  for (const TargetSensor& sensor : hello.sensors)
    text += "; sensor " + sensor.name + (sensor.unit == "1" ? "" : " in " + unit_text(sensor.unit));
  for (const TargetActuator& actuator : hello.actuators)
    text += fmt::format("; actuator {}, {:.4g} to {:.4g} {}", actuator.name, actuator.lower / actuator.to_si,
                        actuator.upper / actuator.to_si, unit_text(actuator.unit));
  return text;
}

}  // namespace lacuna
