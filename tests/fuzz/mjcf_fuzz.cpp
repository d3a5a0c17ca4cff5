// Any text, with a part that it includes, is an MJCF whose robot can be simulated and written back, or is refused.

#include "mjcf_robot.h"
#include "mjcf_writer.h"
#include "robot_fuzzing.h"

namespace {

class Mjcf : public lacuna::RobotFormat {
 public:
  std::string summary() const override { return {}; }
  std::vector<std::string> endings() const override { return {}; }
  lacuna::ReadRobot read(const lacuna::RobotText& file) const override { return lacuna::mjcf::read_robot(file); }
  lacuna::WrittenRobot write(const lacuna::RobotToWrite& robot) const override {
    return lacuna::mjcf::write_mjcf(robot);
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const lacuna::fuzz::FuzzedFiles files(lacuna::fuzz::text_of(data, size));
  lacuna::fuzz::require_way_back(Mjcf(), files, files.file("fuzzed.xml"));
  return 0;
}
