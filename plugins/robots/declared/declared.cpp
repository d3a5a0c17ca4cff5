#include "declared.h"

#include <lacuna/error.h>
#include <lacuna/plugin.h>

namespace lacuna {

std::string Declared::summary() const { return "A robot from a TOML file: bodies, joints, actuators, sensors"; }

RobotSpec Declared::build(const RobotRequest& request) const {
  if (request.declared == nullptr)
    throw Error("it is read from a file and the experiment names none; write [model] file = \"robot.toml\"");
  return *request.declared;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::RobotDefinition, lacuna::Declared>("declared"))
