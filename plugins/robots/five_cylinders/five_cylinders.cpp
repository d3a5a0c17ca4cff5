#include <lacuna/cylinder.h>
#include <lacuna/error.h>
#include <lacuna/plugin.h>
#include <lacuna/robot_definition.h>

#include <array>
#include <cmath>
#include <numbers>

namespace lacuna {

/// The target of J. Bongard, H. Lipson, "Automatic Synthesis of Multiple Internal Models Through Active Exploration",
/// experiment 2: three spinal cylinders and two arms, flat on the ground, four motorised hinges, touch, angle and range
/// sensors. The README describes geometry and conventions.
class FiveCylinders : public RobotDefinition {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  /// Throws `Error` for a number of beacons that is not from 0 to 4.
  RobotSpec build(const RobotRequest& request) const override;
};

namespace {

using Eigen::Vector3d;

constexpr double kGravity = 9.8;  // m/s², as in the source's other experiment
constexpr double kHalfPi = 0.5 * std::numbers::pi;

enum Parameter : std::size_t {
  kRadius,
  kMass,
  kSpineLength,
  kArmLength,
  kArmsInMiddle,
  kRange,
  kSpeedGain,
  kForceLimit,
  kServoDamping,
  kBeacons,
  kBeaconHeight,
  kSink
};

constexpr const char* kBase = "torso";

/// A part with its tail at `tail`, along +x rotated by `yaw` about z.
struct Part {
  const char* name;
  Vector3d tail;
  double yaw;
  double length;
  const char* parent;
};

/// Corners of the square around the start, m.
constexpr std::array<std::array<double, 2>, 4> kBeaconPlaces = {{{-1.0, -1.0}, {1.0, -1.0}, {-1.0, 1.0}, {1.0, 1.0}}};

std::array<Part, 5> parts_of(std::span<const double> p) {
  const double spine = p[kSpineLength], arm = p[kArmLength], height = p[kRadius] - p[kSink];
  const Vector3d head(0.5 * spine, 0.0, height), tail(-0.5 * spine, 0.0, height), middle(spine, 0.0, height);
  const bool in_middle = p[kArmsInMiddle] >= 0.5;
  const Vector3d& shoulder = in_middle ? middle : head;
  const char* arms_on = in_middle ? "front" : kBase;
  return {{{kBase, tail, 0.0, spine, nullptr},
           {"front", head, 0.0, spine, kBase},
           {"rear", tail, 2.0 * kHalfPi, spine, kBase},
           {"left_arm", shoulder, kHalfPi, arm, arms_on},
           {"right_arm", shoulder, -kHalfPi, arm, arms_on}}};
}

Vector3d direction_of(const Part& part) { return {std::cos(part.yaw), std::sin(part.yaw), 0.0}; }

BodySpec body_of(const Part& part, std::span<const double> p) {
  BodySpec body;
  body.name = part.name;
  body.mass = p[kMass];
  body.inertia = solid_cylinder(p[kMass], p[kRadius], part.length);
  body.position = part.tail + 0.5 * part.length * direction_of(part);
  body.orientation = Eigen::AngleAxisd(part.yaw, Vector3d::UnitZ());
  body.shapes = {{.kind = ShapeKind::cylinder,
                  .size = {p[kRadius], part.length, 0.0},
                  .orientation = Eigen::Quaterniond(Eigen::AngleAxisd(kHalfPi, Vector3d::UnitY()))}};
  return body;
}

JointSpec joint_of(const Part& part, std::span<const double> p) {
  JointSpec joint;
  joint.name = part.name;
  joint.parent = part.parent;
  joint.child = part.name;
  joint.anchor = part.tail;
  joint.axis = direction_of(part).cross(Vector3d::UnitZ());
  joint.lower = -p[kRange];
  joint.upper = p[kRange];
  return joint;
}

ActuatorSpec servo_of(const Part& part, std::span<const double> p) {
  ActuatorSpec actuator;
  actuator.name = std::string("motor_") + part.name;
  actuator.joint = part.name;
  actuator.kind = ActuatorKind::position_servo;
  actuator.relative = true;
  actuator.gain = p[kRange];  // a controller's output lies in [-1, 1]
  actuator.command_lower = -p[kRange];
  actuator.command_upper = p[kRange];
  actuator.kd = p[kServoDamping];
  actuator.kp = p[kSpeedGain] * p[kServoDamping];
  actuator.force_limit = p[kForceLimit];
  return actuator;
}

SensorSpec sensor(const std::string& name, SensorKind kind, const std::string& element) {
  SensorSpec spec;
  spec.name = name;
  spec.kind = kind;
  spec.element = element;
  return spec;
}

void add_sensors(RobotSpec& robot, const std::array<Part, 5>& parts, std::span<const double> p) {
  robot.sensors.push_back(sensor("touch_1", SensorKind::touch, "front"));
  robot.sensors.push_back(sensor("touch_2", SensorKind::touch, "rear"));
  for (const Part& part : parts) {
    if (!part.parent) continue;
    robot.sensors.push_back(sensor(std::string("angle_") + part.name, SensorKind::joint_position, part.name));
    robot.sensors.back().relative = true;
    robot.sensors.back().scale = 1.0 / p[kRange];
  }
  for (std::size_t b = 0; b < static_cast<std::size_t>(p[kBeacons]); ++b)
    for (const Part& part : parts) {
      const std::string name = std::string("range_") + part.name + "_" + std::to_string(b + 1);
      robot.sensors.push_back(sensor(name, SensorKind::beacon_range, part.name));
      robot.sensors.back().beacon = {kBeaconPlaces[b][0], kBeaconPlaces[b][1], p[kBeaconHeight]};
    }
}

}  // namespace

std::string FiveCylinders::summary() const {
  return "The seed's robot of unknown shape: three spinal cylinders and two arms, four hinges";
}

ParameterDeclarations FiveCylinders::parameters() const {
  return {
      {"radius", "m", 0.1, 1e-3, 10.0, Scale::linear,
       "Radius of each part; the height of all parts at the start is the radius minus sink"},
      {"mass", "kg", 1.0, 1e-6, 1e6, Scale::logarithmic, "Mass of each part"},
      {"spine_length", "m", 1.0, 1e-3, 100.0, Scale::linear, "Length of each of the three spinal parts"},
      {"arm_length", "m", 0.8, 1e-3, 100.0, Scale::linear, "Length of each arm"},
      {"arms_in_middle", "1", 0.0, 0.0, 1.0, Scale::linear,
       "Attachment of the arms: 1: middle of the front part, one reading of the source's text; 0: head of the torso, "
       "which head-or-tail encodings can express"},
      {"range", "rad", std::numbers::pi / 6.0, 1e-3, 3.0, Scale::linear,
       "Largest hinge angle, command and angle reading, in both directions"},
      {"speed_gain", "1/s", 8.0, 0.0, 1e3, Scale::linear, "Speed that a servo requests per radian of position error"},
      {"force_limit", "N*m", 40.0, 0.0, 1e4, Scale::linear, "Largest torque of a servo"},
      {"servo_damping", "N*m*s/rad", 400.0, 1e-3, 1e6, Scale::logarithmic,
       "Torque of a servo per speed error, up to its limit"},
      {"beacons", "1", 4.0, 0.0, 4.0, Scale::linear, "Number of beacons to which the range of each part is measured"},
      {"beacon_height", "m", 0.0, -100.0, 100.0, Scale::linear, "Height of all beacons above the ground"},
      {"sink", "m", 1e-5, 0.0, 0.1, Scale::linear,
       "Initial depth of all parts in the ground; at 0 rounding decides which parts touch it first"}};
}

RobotSpec FiveCylinders::build(const RobotRequest& request) const {
  const std::span<const double> p = request.parameters;
  if (p[kBeacons] != std::floor(p[kBeacons])) throw Error("beacons must be a whole number from 0 to 4");
  if (p[kArmsInMiddle] != std::floor(p[kArmsInMiddle]))
    throw Error("arms_in_middle must be 0 (at the torso's head) or 1 (in its middle)");
  RobotSpec robot;
  robot.name = "five_cylinders";
  const std::array<Part, 5> parts = parts_of(p);
  for (const Part& part : parts) {
    robot.bodies.push_back(body_of(part, p));
    if (!part.parent) continue;
    robot.joints.push_back(joint_of(part, p));
    robot.actuators.push_back(servo_of(part, p));
  }
  add_sensors(robot, parts, p);
  robot.contact.ground = true;
  robot.gravity = {0.0, 0.0, -kGravity};
  return robot;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::RobotDefinition, lacuna::FiveCylinders>("five_cylinders"))
