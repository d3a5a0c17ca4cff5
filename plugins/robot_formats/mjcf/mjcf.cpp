#include "mjcf_robot.h"
#include "mjcf_writer.h"

#include "xml_element.h"

#include <lacuna/plugin.h>

namespace lacuna {
namespace {

class Mjcf : public RobotFormat {
 public:
  std::string summary() const override { return "Robots in the format of MuJoCo (MJCF)"; }
  std::vector<std::string> endings() const override { return {".mjcf", ".xml"}; }
  bool is_meant(const std::string& text) const override { return robot_files::root_name(text) == "mujoco"; }
  ReadRobot read(const RobotText& file) const override { return mjcf::read_robot(file); }
  WrittenRobot write(const RobotToWrite& robot) const override { return mjcf::write_mjcf(robot); }
};

}  // namespace
}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::RobotFormat, lacuna::Mjcf>("mjcf"))
