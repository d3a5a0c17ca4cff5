#include "simulation/articulated/articulated_engine.h"

#include "simulation/articulated/articulated_motion.h"

#include <lacuna/error.h>

#include <algorithm>

namespace lacuna::articulated {

std::string unsuited(const RobotSpec& robot) {
  const bool has_shapes =
      std::any_of(robot.bodies.begin(), robot.bodies.end(), [](const BodySpec& body) { return !body.shapes.empty(); });
  if (robot.contact.ground && has_shapes) return "the robot has shapes that may touch the ground";
  return {};
}

std::unique_ptr<CompiledModel> compile(ModelStructure structure, const EngineSettings& settings) {
  if (const std::string why = unsuited(structure.robot); !why.empty())
    throw Error("engine.engine is \"articulated\", which has no contacts, but " + why + "; set engine = \"ode\"");
  return std::make_unique<simulation::EngineModel>(
      std::move(structure), settings,
      [](const simulation::EngineModel& model) { return std::make_unique<ArticulatedMotion>(model); });
}

}  // namespace lacuna::articulated
