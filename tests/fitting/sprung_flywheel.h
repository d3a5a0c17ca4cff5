#pragma once

#include "fitting/analytic_models.h"
#include "fitting/fit.h"
#include "support/robots.h"

#include <memory>
#include <string>

namespace lacuna::flywheel {

inline constexpr double kInterval = 0.01;   ///< s
inline constexpr double kDeviation = 1e-3;  ///< rad
inline constexpr double kStart = 0.2;       ///< rad

/// A flywheel on a spring of so many rad/s, lightly damped, driven by a motor.
inline ModelDefinition sprung(double frequency, const std::string& engine = "articulated") {
  ModelDefinition definition;
  RobotSpec& robot = definition.structure.robot;
  robot = one_joint(JointKind::hinge, 1.0);
  robot.sensors = {make_sensor("position", SensorKind::joint_position, "joint")};
  robot.sensors[0].noise = kDeviation;
  robot.joints[0].stiffness = frequency * frequency;
  robot.joints[0].damping = 0.02 * frequency;
  definition.engine.engine = engine;
  definition.engine.step = kInterval;
  return definition;
}

inline std::unique_ptr<CompiledModel> compiled(ModelDefinition definition, int substeps) {
  definition.engine.substeps = substeps;
  return compile(definition.structure, definition.engine);
}

/// Four seconds of its motion, integrated finely.
inline Trial recorded(const ModelDefinition& definition) {
  const std::unique_ptr<CompiledModel> fine = compiled(definition, 200);
  Trial trial = analytic::record(*fine, {}, analytic::regular_times(401, 1.0 / kInterval),
                                 analytic::two_sines(4.0, 0.3), {{kStart}, {0.0}}, kDeviation, 1);
  trial.initial = {{InitialKnowledge::given, kStart, 0.0}};
  return trial;
}

/// The same flywheel, whose spring is to be fitted.
inline ModelDefinition with_free_spring(double frequency) {
  ModelDefinition definition = sprung(frequency);
  const double stiffness = frequency * frequency;
  definition.free = {analytic::free_value("joint.joint.stiffness", 1.02 * stiffness, 0.5 * stiffness, 2.0 * stiffness)};
  definition.structure.parameters = {{"joint.joint.stiffness", 0.5 * stiffness, 2.0 * stiffness}};
  return definition;
}

/// The spring as a fit with so many substeps finds it.
inline FittedValue fitted_spring(const ModelDefinition& definition, const std::vector<Trial>& trials, int substeps) {
  const std::unique_ptr<CompiledModel> model = compiled(definition, substeps);
  return fit({definition, *model, trials, {}, 1, {1}}).values[0];
}

}  // namespace lacuna::flywheel
