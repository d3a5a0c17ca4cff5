#include "config/robots/robot_reader.h"

#include "config/robots/robot_checks.h"
#include "config/schema/robot_file.h"
#include "config/robots/robot_masses.h"
#include "config/toml/text_file.h"
#include "config/toml/toml_parser.h"
#include "foundation/address.h"
#include "foundation/unit.h"

namespace lacuna {
namespace {

Eigen::Vector3d origin_of(const RobotSpec& robot, const std::string& name) {
  for (const BodySpec& body : robot.bodies)
    if (body.name == name) return body.position;
  return Eigen::Vector3d::Zero();
}

RobotSpec assembled(const RobotInFile& file, const Locations& locations, Reading& reading) {
  RobotSpec robot;
  robot.name = file.name;
  robot.gravity = file.gravity;
  robot.contact = file.contact;
  robot.actuators = file.actuators;
  robot.couplings = file.couplings;
  for (const BodyInFile& body : file.bodies) {
    const bool is_readable = !reading.is_troubled("body." + body.spec.name);
    robot.bodies.push_back(is_readable ? resolve_body(body, locations, reading) : body.spec);
  }
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

/// "joint.hinge" of "joint.hinge.damping".
std::string element_of(const std::string& address) {
  return address.substr(0, address.find('.', address.find('.') + 1));
}

/// A hinge's damping is in N*m*s/rad, a slider's in N*s/m: known once the robot is put together.
void check_written_units(RobotSpec& robot, const Locations& locations, Reading& reading) {
  const std::map<std::string, std::string>& written = reading.written_units();
  for (const AddressedValue& value : addressed_values(robot)) {
    const auto found = written.find(value.address);
    if (found == written.end() || reading.is_troubled(element_of(value.address))) continue;
    if (parse_unit(found->second)->same_dimension(*parse_unit(value.unit))) continue;
    reading.problem_at(value.address, nearest_location(locations, value.address, ""),
                       "is in " + found->second + ", but must be in " + value.unit + " or a multiple of it");
  }
}

}  // namespace

RobotSpec read_robot_text(const std::string& text, const std::filesystem::path& file, Locations* places) {
  const TomlNode tree = parse_toml(text, file.string());
  const Locations locations = locations_of(tree);
  ProblemList problems;
  Reading reading(problems, file.parent_path());
  RobotInFile written;
  static const Value<RobotInFile> kKeys = robot_keys().value();
  kKeys.read(tree, reading, written);
  check_robot(written, locations, reading);
  RobotSpec robot = assembled(written, locations, reading);
  check_written_units(robot, locations, reading);
  problems.throw_if_any();
  if (places != nullptr) *places = locations;
  return robot;
}

RobotSpec read_robot(const std::filesystem::path& file) { return read_robot_text(read_text_file(file), file); }

}  // namespace lacuna
