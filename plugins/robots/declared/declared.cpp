#include <lacuna/error.h>
#include <lacuna/plugin.h>
#include <lacuna/robot_definition.h>

namespace lacuna {

/// A robot from a TOML file: the host reads the file, this plugin passes it on.
class Declared : public RobotDefinition {
 public:
  std::string summary() const override;
  /// Throws `Error` where the experiment names no robot file.
  RobotSpec build(const RobotRequest& request) const override;
};

std::string Declared::summary() const { return "A robot from a TOML file: bodies, joints, actuators, sensors"; }

RobotSpec Declared::build(const RobotRequest& request) const {
  if (request.declared == nullptr)
    throw Error("the experiment names no robot file; write [model] file = \"robot.toml\"");
  return *request.declared;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::RobotDefinition, lacuna::Declared>("declared"))
