#include "simulation/ode/ode_engine.h"

#include "simulation/ode/ode_motion.h"

#include <lacuna/error.h>

namespace lacuna::ode {
namespace {

bool is_known(ActuatorKind kind) {
  return kind == ActuatorKind::force || kind == ActuatorKind::velocity_servo || kind == ActuatorKind::position_servo ||
         kind == ActuatorKind::pid;
}

}  // namespace

std::unique_ptr<CompiledModel> compile(ModelStructure structure, const EngineSettings& settings) {
  for (const ActuatorSpec& actuator : structure.robot.actuators)
    if (!is_known(actuator.kind))
      throw Error("actuator \"" + actuator.name +
                  "\": the engine \"ode\" supports neither motors with a voltage nor imposed motion; use the engine "
                  "\"articulated\", for robots without contacts");
  if (!structure.robot.couplings.empty())
    throw Error("coupling \"" + structure.robot.couplings.front().name +
                "\": the engine \"ode\" does not support coupled joints; use the engine \"articulated\", for robots "
                "without contacts");
  return std::make_unique<simulation::EngineModel>(
      std::move(structure), settings,
      [](const simulation::EngineModel& model) { return std::make_unique<OdeMotion>(model); });
}

}  // namespace lacuna::ode
