#include <lacuna/plugin.h>
#include <lacuna/robot_definition.h>

#include <array>
#include <cmath>
#include <numbers>

namespace lacuna {

/// The quadruped of J. Bongard, H. Lipson, "Automatic Synthesis of Multiple Internal Models Through Active
/// Exploration", experiment 1: a torso, four legs of two parts, eight motorised hinges, touch sensors on the lower legs
/// and angle sensors at the knees. The README describes geometry and conventions.
class Quadruped : public RobotDefinition {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  RobotSpec build(const RobotRequest& request) const override;
};

namespace {

using Eigen::Vector3d;

/// The source has y up; here z is up and x forward. Only this function converts its figures.
Vector3d from_source(double x, double y, double z) { return {z, x, y}; }

/// Knees in the source's figures are at (±1, 1.6, ±1). Order: B2/B3, B4/B5, B6/B7, B8/B9.
struct Leg {
  const char* name;
  double source_x;  // positive: left
  double source_z;  // positive: front
};
constexpr std::array<Leg, 4> kLegs = {
    {{"front_left", 1.0, 1.0}, {"front_right", -1.0, 1.0}, {"rear_left", 1.0, -1.0}, {"rear_right", -1.0, -1.0}}};

constexpr double kHeight = 0.85;  // of the torso and of the lower legs' centres, m
constexpr double kUpperCentreHeight = 1.225;
constexpr double kKneeHeight = 1.6;
constexpr double kLegRadius = 0.1;
constexpr double kLegLength = 1.5;                 // without caps: a lower leg reaches from the ground to the knee
constexpr double kRange = std::numbers::pi / 6.0;  // of joints and commands, rad
constexpr double kGravity = 9.8;

/// Indices of the parameters; two masses per leg follow.
enum Parameter : std::size_t { kSpeedGain, kForceLimit, kServoDamping, kTorsoRadius, kTorsoMass };

InertiaSpec solid_sphere(double mass, double radius) {
  const double moment = 0.4 * mass * radius * radius;
  return {.xx = moment, .yy = moment, .zz = moment};
}

/// A solid capsule along z: a cylinder and two hemispheres of one density.
InertiaSpec solid_capsule(double mass, double radius, double length) {
  const double cylinder = length, caps = 4.0 / 3.0 * radius;  // volumes over pi r²
  const double m_cylinder = mass * cylinder / (cylinder + caps);
  const double m_caps = mass - m_cylinder;
  const double r2 = radius * radius;
  const double along = 0.5 * m_cylinder * r2 + 0.4 * m_caps * r2;
  const double across = m_cylinder * (length * length / 12.0 + r2 / 4.0) +
                        m_caps * (0.4 * r2 + length * length / 4.0 + 3.0 / 8.0 * length * radius);
  return {.xx = across, .yy = across, .zz = along};
}

BodySpec torso(double mass, double radius) {
  BodySpec body;
  body.name = "torso";
  body.mass = mass;
  body.inertia = solid_sphere(mass, radius);
  body.position = from_source(0.0, kHeight, 0.0);
  body.shapes = {{.kind = ShapeKind::sphere, .size = {radius, 0.0, 0.0}}};
  return body;
}

/// The shortest rotation of z onto a direction that is not its opposite. Eigen's `FromTwoVectors` gives the same, but
/// takes twenty times as long to compile as everything else here.
Eigen::Quaterniond turn_of_z_onto(const Vector3d& direction) {
  const Vector3d along = direction.normalized();
  const double s = std::sqrt((1.0 + along.z()) * 2.0);
  const Vector3d axis = Vector3d::UnitZ().cross(along) * (1.0 / s);
  return {0.5 * s, axis.x(), axis.y(), axis.z()};
}

BodySpec leg_part(const std::string& name, double mass, const Vector3d& centre, const Vector3d& direction) {
  BodySpec body;
  body.name = name;
  body.mass = mass;
  body.inertia = solid_capsule(mass, kLegRadius, kLegLength);
  body.position = centre;
  body.orientation = turn_of_z_onto(direction);
  return body;
}

JointSpec hinge(const std::string& name, const std::string& parent, const std::string& child, const Vector3d& anchor,
                const Vector3d& axis) {
  JointSpec joint;
  joint.name = name;
  joint.parent = parent;
  joint.child = child;
  joint.anchor = anchor;
  joint.axis = axis;
  joint.lower = -kRange;
  joint.upper = kRange;
  return joint;
}

ActuatorSpec servo(const std::string& joint, std::span<const double> parameters) {
  ActuatorSpec actuator;
  actuator.name = joint;
  actuator.joint = joint;
  actuator.kind = ActuatorKind::position_servo;
  actuator.relative = true;
  actuator.gain = kRange;  // a controller's output lies in [-1, 1]
  actuator.command_lower = -kRange;
  actuator.command_upper = kRange;
  actuator.kd = parameters[kServoDamping];
  actuator.kp = parameters[kSpeedGain] * parameters[kServoDamping];
  actuator.force_limit = parameters[kForceLimit];
  return actuator;
}

SensorSpec sensor(const std::string& name, SensorKind kind, const std::string& element) {
  SensorSpec spec;
  spec.name = name;
  spec.kind = kind;
  spec.element = element;
  return spec;
}

void add_leg(RobotSpec& robot, const Leg& leg, double lower_mass, double upper_mass,
             std::span<const double> parameters) {
  const std::string name = leg.name;
  const Vector3d hip = from_source(0.0, kHeight, 0.0);
  const Vector3d knee = from_source(leg.source_x, kKneeHeight, leg.source_z);
  const Vector3d outward = Vector3d(knee.x(), knee.y(), 0.0).normalized();
  const Vector3d axis = outward.cross(Vector3d::UnitZ());  // positive: knee up, foot out

  BodySpec lower =
      leg_part(name + "_lower", lower_mass, from_source(leg.source_x, kHeight, leg.source_z), Vector3d::UnitZ());
  lower.shapes = {{.kind = ShapeKind::capsule, .size = {kLegRadius, kLegLength, 0.0}}};
  robot.bodies.push_back(std::move(lower));
  robot.bodies.push_back(leg_part(name + "_upper", upper_mass,
                                  from_source(0.5 * leg.source_x, kUpperCentreHeight, 0.5 * leg.source_z), knee - hip));
  robot.joints.push_back(hinge(name + "_hip", "torso", name + "_upper", hip, axis));
  robot.joints.push_back(hinge(name + "_knee", name + "_upper", name + "_lower", knee, axis));
  robot.actuators.push_back(servo(name + "_hip", parameters));
  robot.actuators.push_back(servo(name + "_knee", parameters));
}

void add_sensors(RobotSpec& robot) {
  for (const Leg& leg : kLegs)
    robot.sensors.push_back(
        sensor("touch_" + std::string(leg.name), SensorKind::touch, leg.name + std::string("_lower")));
  for (const Leg& leg : kLegs) {
    SensorSpec angle =
        sensor("angle_" + std::string(leg.name), SensorKind::joint_position, leg.name + std::string("_knee"));
    angle.relative = true;
    angle.scale = 1.0 / kRange;
    robot.sensors.push_back(std::move(angle));
  }
}

ParameterDeclaration mass_parameter(const std::string& body) {
  return {body + "_mass", "kg", 1.0, 1e-3, 1e3, Scale::linear, "Mass of " + body};
}

}  // namespace

std::string Quadruped::summary() const {
  return "The seed's quadruped: torso, four two-part legs, eight servos, touch and knee sensors";
}

ParameterDeclarations Quadruped::parameters() const {
  ParameterDeclarations parameters = {
      {"speed_gain", "1/s", 8.0, 0.0, 1e3, Scale::linear, "Speed that a servo requests per radian of position error"},
      {"force_limit", "N*m", 40.0, 0.0, 1e4, Scale::linear, "Largest torque of a servo"},
      {"servo_damping", "N*m*s/rad", 400.0, 1e-3, 1e6, Scale::logarithmic,
       "Torque of a servo per speed error, up to its limit"},
      {"torso_radius", "m", 0.2, 0.01, 0.8, Scale::linear, "Radius of the torso, a sphere"},
      mass_parameter("torso")};
  for (const Leg& leg : kLegs) {
    parameters.push_back(mass_parameter(leg.name + std::string("_lower")));
    parameters.push_back(mass_parameter(leg.name + std::string("_upper")));
  }
  return parameters;
}

RobotSpec Quadruped::build(const RobotRequest& request) const {
  const std::span<const double> parameters = request.parameters;
  RobotSpec robot;
  robot.name = "quadruped";
  robot.bodies.push_back(torso(parameters[kTorsoMass], parameters[kTorsoRadius]));
  for (std::size_t i = 0; i < kLegs.size(); ++i)
    add_leg(robot, kLegs[i], parameters[kTorsoMass + 1 + 2 * i], parameters[kTorsoMass + 2 + 2 * i], parameters);
  add_sensors(robot);
  robot.contact.ground = true;
  robot.gravity = {0.0, 0.0, -kGravity};
  return robot;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::RobotDefinition, lacuna::Quadruped>("quadruped"))
