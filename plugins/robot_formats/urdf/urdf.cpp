#include "urdf_robot.h"
#include "urdf_writer.h"

#include "xml_element.h"

#include <lacuna/plugin.h>

namespace lacuna {
namespace {

class Urdf : public RobotFormat {
 public:
  std::string summary() const override { return "Robots in the format of ROS (URDF)"; }
  std::vector<std::string> endings() const override { return {".urdf", ".xml"}; }
  bool is_meant(const std::string& text) const override { return robot_files::root_name(text) == "robot"; }
  ReadRobot read(const RobotText& file) const override {
    return urdf::robot_of(urdf::read_file(file.text, file.base), file.base);
  }
  WrittenRobot write(const RobotToWrite& robot) const override { return urdf::write_urdf(robot); }
};

}  // namespace
}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::RobotFormat, lacuna::Urdf>("urdf"))
