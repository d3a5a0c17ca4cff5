// Any text is a URDF, whose robot can be simulated and written back, or is refused with sentences.

#include "robot_fuzzing.h"
#include "urdf_robot.h"
#include "urdf_writer.h"

namespace {

class Urdf : public lacuna::RobotFormat {
 public:
  std::string summary() const override { return {}; }
  std::vector<std::string> endings() const override { return {}; }
  lacuna::ReadRobot read(const lacuna::RobotText& file) const override {
    return lacuna::urdf::robot_of(lacuna::urdf::read_file(file.text, file.base), file.base);
  }
  lacuna::WrittenRobot write(const lacuna::RobotToWrite& robot) const override {
    return lacuna::urdf::write_urdf(robot);
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const lacuna::fuzz::FuzzedFiles files(lacuna::fuzz::text_of(data, size));
  for (const lacuna::RobotBase base : {lacuna::RobotBase::as_written, lacuna::RobotBase::free})
    lacuna::fuzz::require_way_back(Urdf(), files, files.file("fuzzed.urdf", base));
  return 0;
}
