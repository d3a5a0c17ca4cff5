#include "urdf_robot.h"

#include <lacuna/plugin.h>

namespace lacuna {
namespace {

class Urdf : public RobotFormat {
 public:
  std::string summary() const override { return "Robots as ROS describes them (URDF)"; }
  std::vector<std::string> endings() const override { return {".urdf"}; }
  ReadRobot read(const RobotText& file) const override { return urdf::robot_of(urdf::read_file(file.text)); }
};

}  // namespace
}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::RobotFormat, lacuna::Urdf>("urdf"))
