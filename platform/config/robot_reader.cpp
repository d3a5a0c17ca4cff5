#include "config/robot_reader.h"

#include "config/robot_checks.h"
#include "config/robot_file.h"
#include "config/robot_masses.h"
#include "config/text_file.h"
#include "config/toml_parser.h"
#include "foundation/address.h"
#include "foundation/unit.h"

namespace lacuna {
namespace {

Eigen::Vector3d origin_of(const RobotSpec& robot, const std::string& name) {
  for (const BodySpec& body : robot.bodies)
    if (body.name == name) return body.position;
  return Eigen::Vector3d::Zero();
}

RobotSpec assembled(const RobotInFile& file, const Locations& locations, ProblemList& problems) {
  RobotSpec robot;
  robot.name = file.name;
  robot.gravity = file.gravity;
  robot.contact = file.contact;
  robot.actuators = file.actuators;
  for (const BodyInFile& body : file.bodies) robot.bodies.push_back(resolve_body(body, locations, problems));
  for (const JointInFile& joint : file.joints) {
    robot.joints.push_back(joint.spec);
    robot.joints.back().anchor = joint.anchor.value_or(origin_of(robot, joint.spec.child));
    if (joint.axis2) robot.joints.back().axis2 = *joint.axis2;
  }
  for (const SensorInFile& sensor : file.sensors) {
    robot.sensors.push_back(sensor.spec);
    robot.sensors.back().element = sensor.joint.empty() ? sensor.body : sensor.joint;
  }
  return robot;
}

/// A hinge's damping is in N*m*s/rad, a slider's in N*s/m: known once the robot is put together.
void check_written_units(RobotSpec& robot, const Reading& reading, const Locations& locations, ProblemList& problems) {
  const std::map<std::string, std::string>& written = reading.written_units();
  for (const AddressedValue& value : addressed_values(robot)) {
    const auto found = written.find(value.address);
    if (found == written.end() || parse_unit(found->second)->same_dimension(*parse_unit(value.unit))) continue;
    problems.add(
        nearest_location(locations, value.address, ""),
        value.address + ": is in " + found->second + ", but must be in " + value.unit + " or a multiple of it");
  }
}

}  // namespace

RobotSpec read_robot_text(const std::string& text, const std::filesystem::path& file) {
  const TomlNode tree = parse_toml(text, file.string());
  ProblemList problems;
  Reading reading(problems, file.parent_path());
  RobotInFile written;
  const bool readable = robot_keys().value().read(tree, reading, written);
  if (!readable) problems.throw_if_any();
  const Locations locations = locations_of(tree);
  check_robot(written, locations, problems);
  RobotSpec robot = assembled(written, locations, problems);
  problems.throw_if_any();
  check_written_units(robot, reading, locations, problems);
  problems.throw_if_any();
  return robot;
}

RobotSpec read_robot(const std::filesystem::path& file) { return read_robot_text(read_text_file(file), file); }

}  // namespace lacuna
