#include "config/schema/robot_file.h"

#include <cmath>

namespace lacuna {
namespace {

Value<Eigen::Quaterniond> orientation() {
  return mapped<Eigen::Quaterniond, Eigen::Vector3d>(
      vector3("rad"), [](Eigen::Vector3d&& rpy) { return orientation_from_rpy(rpy); },
      [](const Eigen::Quaterniond&) { return std::string("[0.0, 0.0, 0.0]"); });
}

/// A direction: "x", "-z", or three numbers that need not have length one.
Value<Eigen::Vector3d> direction() {
  using Vector = Eigen::Vector3d;
  const Value<Vector> letter = choice<Vector>({{"x", Vector::UnitX()},
                                               {"y", Vector::UnitY()},
                                               {"z", Vector::UnitZ()},
                                               {"-x", -Vector::UnitX()},
                                               {"-y", -Vector::UnitY()},
                                               {"-z", -Vector::UnitZ()}});
  Value<Vector> numbers = vector3("1");
  numbers.read = [plain = numbers.read](const TomlNode& node, Reading& reading, Vector& result) {
    if (!plain(node, reading, result)) return false;
    const double length = result.norm();
    if (std::isnormal(length)) {
      result /= length;
      return true;
    }
    reading.problem(node, "a direction must not have length zero");
    return false;
  };
  return either(letter, numbers);
}

/// Above 0, which a point mass and a thin rod do not have about each axis.
Value<double> moment_of_inertia() {
  Value<double> moment = number("kg*m^2").above(0.0);
  moment.read = [strict = moment.read](const TomlNode& node, Reading& reading, double& result) {
    const bool is_zero = node.kind == TomlNode::Kind::integer ? node.integer == 0 : node.real == 0.0;
    if (!node.is_number() || !is_zero) return strict(node, reading, result);
    reading.problem(
        node,
        "must be above 0 kg*m^2; for a point mass or a thin rod write a moment that is too small to matter, "
        "such as \"1e-6 kg*m^2\"");
    return false;
  };
  return moment;
}

Value<InertiaSpec> inertia() {
  const auto moment = moment_of_inertia();
  const auto product = number("kg*m^2");
  Value<InertiaSpec> table = Table<InertiaSpec>()
                                 .required("xx", &InertiaSpec::xx, moment, "moment about the body's x through the com")
                                 .required("yy", &InertiaSpec::yy, moment, "about y")
                                 .required("zz", &InertiaSpec::zz, moment, "about z")
                                 .key("xy", &InertiaSpec::xy, product, "product of inertia")
                                 .key("xz", &InertiaSpec::xz, product, "product of inertia")
                                 .key("yz", &InertiaSpec::yz, product, "product of inertia")
                                 .value();
  Value<std::vector<double>> moments = list_of<double>(moment, 3);
  moments.shape.most = 3;
  Value<InertiaSpec> list;
  list.shape = moments.shape;
  list.shape.meaning = "xx, yy, zz";
  list.read = [moments](const TomlNode& node, Reading& reading, InertiaSpec& result) {
    std::vector<double> read;
    if (!fits_list(moments.shape, node, reading) || !moments.read(node, reading, read)) return false;
    result = {read[0], read[1], read[2], 0.0, 0.0, 0.0};
    return true;
  };
  list.write = [](const InertiaSpec&) { return std::string(); };
  return either(list, table);
}

Table<ShapeInFile> shape_keys() {
  const auto length = number("m").above(0.0);
  Value<Eigen::Vector3d> edges = vector3("m");
  edges.read = [plain = edges.read](const TomlNode& node, Reading& reading, Eigen::Vector3d& result) {
    if (!plain(node, reading, result)) return false;
    if (result.minCoeff() > 0.0) return true;
    reading.problem(node, "an edge's length must be above 0 m");
    return false;
  };
  return Table<ShapeInFile>()
      .required<ShapeKind>(
          "kind",
          choice<ShapeKind>({{"box", ShapeKind::box},
                             {"sphere", ShapeKind::sphere},
                             {"capsule", ShapeKind::capsule},
                             {"cylinder", ShapeKind::cylinder}}),
          [](ShapeInFile& shape, ShapeKind&& kind) { shape.spec.kind = kind; }, "form of the shape")
      .key("size", &ShapeInFile::size, edges, "of a box: its edges along x, y, z")
      .key("radius", &ShapeInFile::radius, length, "of a sphere, capsule or cylinder")
      .key("length", &ShapeInFile::length, length, "of a capsule (without its caps) or a cylinder")
      .key<Eigen::Vector3d>(
          "at", vector3("m"), {0.0, 0.0, 0.0},
          [](ShapeInFile& shape, Eigen::Vector3d&& at) { shape.spec.position = at; }, "its centre in the body frame")
      .key("along", &ShapeInFile::along, direction(), "direction of the shape's z axis, in the body frame")
      .key("rpy", &ShapeInFile::rpy, vector3("rad"), "instead of along: rotation about the body's x, then y, then z")
      .key("mass", &ShapeInFile::mass, number("kg").above(0.0), "gives the body's mass and inertia")
      .key("density", &ShapeInFile::density, number("kg/m^3").above(0.0), "instead of mass")
      .key("collides", &ShapeInFile::collides, boolean(), "false: the shape has mass but no contact");
}

Table<BodyInFile> body_keys() {
  const Table<BodySpec> spec =
      Table<BodySpec>()
          .key("at", &BodySpec::position, vector3("m"), "origin of the body frame in the world, all joints at zero")
          .key("rpy", &BodySpec::orientation, orientation(), "rotation about the world's x, then y, then z")
          .key("inertia_scales_with_mass", &BodySpec::inertia_scales_with_mass, boolean(),
               "if only the mass is set or fitted, the inertia scales with it");
  return Table<BodyInFile>()
      .merged(&BodyInFile::spec, spec)
      .key("mass", &BodyInFile::mass, number("kg").above(0.0), "default: the sum of the shapes' masses")
      .key("com", &BodyInFile::com, vector3("m"),
           "centre of mass in the body frame; default: the shapes' centre of mass")
      .key("inertia", &BodyInFile::inertia, inertia(),
           "about the centre of mass, along the body's axes; default: the shapes' inertia")
      .key("shapes", &BodyInFile::shapes, list_of(shape_keys().value()),
           "Shapes for contact with the ground, and for mass and inertia.");
}

Table<JointSpec> joint_law_keys() {
  const auto position = number("rad or m");
  return Table<JointSpec>()
      .key("kind", &JointSpec::kind,
           choice<JointKind>({{"hinge", JointKind::hinge},
                              {"slider", JointKind::slider},
                              {"fixed", JointKind::fixed},
                              {"ball", JointKind::ball},
                              {"free", JointKind::free},
                              {"universal", JointKind::universal}}),
           "motion that the joint allows")
      .key("parent", &JointSpec::parent, element_name(), "a body, or \"world\"")
      .required("child", &JointSpec::child, element_name(), "the body that moves")
      .key("axis", &JointSpec::axis, direction(),
           "axis in the world, all joints at zero; positive by the right-hand rule")
      .key("lower", &JointSpec::lower, NumberValue(position).or_infinite(), "stop")
      .key("upper", &JointSpec::upper, NumberValue(position).or_infinite(), "stop")
      .key("damping", &JointSpec::damping, number("N*m*s/rad or N*s/m").at_least(0.0), "viscous friction")
      .key("dry_friction", &JointSpec::dry_friction, number("N*m or N").at_least(0.0), "Coulomb friction")
      .key("stiffness", &JointSpec::stiffness, number("N*m/rad or N/m").at_least(0.0),
           "stiffness of a spring to the position rest")
      .key("rest", &JointSpec::rest, position, "rest position of the spring")
      .key("armature", &JointSpec::armature, number("kg*m^2 or kg").at_least(0.0),
           "inertia added to the joint's coordinate")
      .key("force", &JointSpec::force, number("N*m or N"), "constant force or torque");
}

Table<JointInFile> joint_keys() {
  return Table<JointInFile>()
      .merged(&JointInFile::spec, joint_law_keys())
      .key("anchor", &JointInFile::anchor, vector3("m"),
           "position in the world, all joints at zero; default: the child's origin")
      .key("axis2", &JointInFile::axis2, direction(),
           "of a universal joint: the child's axis, at right angles to axis");
}

Table<TransmissionSpec> transmission_keys() {
  return Table<TransmissionSpec>()
      .key("ratio", &TransmissionSpec::ratio, number("1"), "motor turns per joint turn")
      .key("rotor_inertia", &TransmissionSpec::rotor_inertia, number("kg*m^2 or kg").at_least(0.0),
           "at the motor's shaft")
      .key("stiffness", &TransmissionSpec::stiffness, number("N*m/rad or N/m").above(0.0).or_infinite(),
           "on the joint's side; inf: rigid")
      .key("damping", &TransmissionSpec::damping, number("N*m*s/rad or N*s/m").at_least(0.0), "on the joint's side")
      .key("gap", &TransmissionSpec::gap, number("rad or m").at_least(0.0), "full width of the backlash at the joint");
}

Table<MotorSpec> motor_keys() {
  return Table<MotorSpec>()
      .key("torque_constant", &MotorSpec::torque_constant, number("N*m/A or N/A").above(0.0),
           "joint torque per current")
      .key("resistance", &MotorSpec::resistance, number("Ohm").above(0.0), "of the winding and its driver")
      .key("back_emf", &MotorSpec::back_emf, number("1").at_least(0.0),
           "ratio of back-EMF constant to torque constant; 1: no loss")
      .key("supply", &MotorSpec::supply, number("V").above(0.0).or_infinite(), "supply voltage; required for a servo")
      .key("duty_limit", &MotorSpec::duty_limit, number("1").above(0.0),
           "largest share of the supply voltage that the driver applies")
      .key("gain_unit", &MotorSpec::gain_unit, number("1/rad or 1/m").above(0.0),
           "servo: share of the supply voltage per rad or m for one count of kp")
      .key("sample_time", &MotorSpec::sample_time, number("s").at_least(0.0),
           "servo: interval of its position readings, rounded to integration steps; the voltage is constant in "
           "between; 0: continuous");
}

Table<ActuatorSpec> actuator_keys() {
  const std::string command = "";  // force, velocity or position: the kind decides
  return Table<ActuatorSpec>()
      .required("joint", &ActuatorSpec::joint, element_name(), "driven joint")
      .key("kind", &ActuatorSpec::kind,
           choice<ActuatorKind>({{"force", ActuatorKind::force},
                                 {"velocity_servo", ActuatorKind::velocity_servo},
                                 {"position_servo", ActuatorKind::position_servo},
                                 {"pid", ActuatorKind::pid},
                                 {"voltage", ActuatorKind::voltage},
                                 {"voltage_servo", ActuatorKind::voltage_servo},
                                 {"motion", ActuatorKind::motion}}),
           "meaning of the command: a force, a velocity, a position (both servos and pid), a voltage on a motor, a "
           "position "
           "that a servo reaches by a voltage on its motor, or motion: the imposed velocity of the joint")
      .key("gain", &ActuatorSpec::gain, number("1"), "factor of the command, applied first")
      .key("relative", &ActuatorSpec::relative, boolean(),
           "the command has no unit; the gain converts it to a position or force")
      .key("offset", &ActuatorSpec::offset, number(command), "added to the command after the gain")
      .key("delay", &ActuatorSpec::delay, number("s").at_least(0.0), "delay of the command")
      .key("kp", &ActuatorSpec::kp, number("N*m/rad or N/m").at_least(0.0),
           "position servo and pid; voltage servo: in its counts (motor.gain_unit)")
      .key("ki", &ActuatorSpec::ki, number("N*m/(rad*s) or N/(m*s)").at_least(0.0), "of pid")
      .key("kd", &ActuatorSpec::kd, number("N*m*s/rad or N*s/m").at_least(0.0),
           "servos and pid; voltage servo: in counts and s")
      .key("force_limit", &ActuatorSpec::force_limit, number("N*m or N").at_least(0.0).or_infinite(), "at the joint")
      .key("command_lower", &ActuatorSpec::command_lower, number(command).or_infinite(), "commands are clipped to this")
      .key("command_upper", &ActuatorSpec::command_upper, number(command).or_infinite(), "commands are clipped to this")
      .key("transmission", &ActuatorSpec::transmission, transmission_keys().value(),
           "Transmission between motor and joint.")
      .key("motor", &ActuatorSpec::motor, motor_keys().value(), "Motor, for kinds voltage and voltage_servo.");
}

Table<CouplingSpec> coupling_keys() {
  return Table<CouplingSpec>()
      .required("joint", &CouplingSpec::joint, element_name(), "a hinge or slider that follows another")
      .required("follows", &CouplingSpec::follows, element_name(), "the hinge or slider that it follows")
      .key("ratio", &CouplingSpec::ratio, number("1, rad/m or m/rad"), "ratio of its coordinate to the other's")
      .key("offset", &CouplingSpec::offset, number("rad or m"), "its coordinate when the other's is zero");
}

Table<SensorInFile> sensor_keys() {
  const std::string channel = "";  // what is read decides
  const Table<SensorSpec> spec =
      Table<SensorSpec>()
          .required("kind", &SensorSpec::kind,
                    choice<SensorKind>({{"joint_position", SensorKind::joint_position},
                                        {"joint_velocity", SensorKind::joint_velocity},
                                        {"joint_force", SensorKind::joint_force},
                                        {"touch", SensorKind::touch},
                                        {"body_position", SensorKind::body_position},
                                        {"body_velocity", SensorKind::body_velocity},
                                        {"body_orientation", SensorKind::body_orientation},
                                        {"body_angular_velocity", SensorKind::body_angular_velocity},
                                        {"beacon_range", SensorKind::beacon_range},
                                        {"contact_force", SensorKind::contact_force},
                                        {"drive_force", SensorKind::drive_force},
                                        {"link_angle", SensorKind::link_angle},
                                        {"link_velocity", SensorKind::link_velocity},
                                        {"accelerometer", SensorKind::accelerometer}}),
                    "measured quantity")
          .key("beacon", &SensorSpec::beacon, vector3("m"), "beacon_range: point from which the distance is measured")
          .key("at", &SensorSpec::at, vector3("m"), "accelerometer: its position in the body frame")
          .key("delay", &SensorSpec::delay, number("s").at_least(0.0),
               "delay of the reading; before the start it is the initial value")
          .key("scale", &SensorSpec::scale, number("1"), "factor of the reading")
          .key("relative", &SensorSpec::relative, boolean(),
               "the channels have no unit; the scale converts the measured quantity")
          .key("offset", &SensorSpec::offset, number(channel), "added after the scale")
          .key("noise", &SensorSpec::noise, number(channel).at_least(0.0), "standard deviation of white noise")
          .key("quantum", &SensorSpec::quantum, number(channel).at_least(0.0), "step of the quantiser; 0: none");
  return Table<SensorInFile>()
      .merged(&SensorInFile::spec, spec)
      .key("joint", &SensorInFile::joint, element_name(),
           "joint of a joint_*, drive_* or link_* sensor: joint_* relative to its parent, link_* relative to the "
           "world")
      .key("body", &SensorInFile::body, element_name(), "body of any other sensor");
}

Table<ContactSpec> contact_keys() {
  return Table<ContactSpec>()
      .key("ground", &ContactSpec::ground, boolean(), "whether there is a ground plane z = 0")
      .key("stiffness", &ContactSpec::stiffness, number("N/m").above(0.0).or_infinite(), "inf: rigid")
      .key("damping", &ContactSpec::damping, number("N*s/m").at_least(0.0), "of the contact")
      .key("friction", &ContactSpec::friction, number("1").at_least(0.0).or_infinite(), "Coulomb friction coefficient")
      .key("slope", &ContactSpec::slope, number("rad").between(-1.5, 1.5),
           "slope of the ground, about y; positive: descends along x");
}

/// Elements in a table whose keys are their names, kept in a list in the order of the file.
template <class T>
Value<std::vector<T>> elements(const std::string& hint, const Table<T>& keys, std::string& (*name)(T&)) {
  return named<std::vector<T>, T>(hint, keys.value(),
                                  [name](std::vector<T>& list, const TomlMember& member, T&& element) {
                                    name(element) = member.name;
                                    list.push_back(std::move(element));
                                  });
}

}  // namespace

Eigen::Quaterniond orientation_along(const Eigen::Vector3d& direction) {
  constexpr double kOpposite = 1e-12;
  const Eigen::Vector3d along = direction.normalized();
  const double cosine_plus_one = 1.0 + along.z();
  if (cosine_plus_one < kOpposite) return {0.0, 1.0, 0.0, 0.0};
  const double s = std::sqrt(2.0 * cosine_plus_one);
  const Eigen::Vector3d axis = Eigen::Vector3d::UnitZ().cross(along) / s;
  return {0.5 * s, axis.x(), axis.y(), axis.z()};
}

Eigen::Quaterniond orientation_from_rpy(const Eigen::Vector3d& rpy) {
  return Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX());
}

Table<RobotInFile> robot_keys() {
  const Table<RobotInFile> head =
      Table<RobotInFile>().required("name", &RobotInFile::name, element_name(), "name of the robot");
  const Table<RobotInFile> world =
      Table<RobotInFile>().key("gravity", &RobotInFile::gravity, vector3("m/s^2"), "z points up");
  return Table<RobotInFile>()
      .section("robot", head, "Name of the robot.", true)
      .section("world", world, "Surroundings of the robot.")
      .required("body", &RobotInFile::bodies,
                elements<BodyInFile>("BODY", body_keys(), [](BodyInFile& b) -> std::string& { return b.spec.name; }),
                "Rigid bodies. A body that is not the child of a joint floats.")
      .key("joint", &RobotInFile::joints,
           elements<JointInFile>("JOINT", joint_keys(), [](JointInFile& j) -> std::string& { return j.spec.name; }),
           "Joints, each between a parent and a child.")
      .key("actuator", &RobotInFile::actuators,
           elements<ActuatorSpec>("ACTUATOR", actuator_keys(), [](ActuatorSpec& a) -> std::string& { return a.name; }),
           "Actuators, which drive joints.")
      .key("coupling", &RobotInFile::couplings,
           elements<CouplingSpec>("COUPLING", coupling_keys(), [](CouplingSpec& c) -> std::string& { return c.name; }),
           "Gears, belts and linkages that couple two joints: q(joint) = ratio * q(follows) + offset.")
      .key("sensor", &RobotInFile::sensors,
           elements<SensorInFile>("SENSOR", sensor_keys(), [](SensorInFile& s) -> std::string& { return s.spec.name; }),
           "Sensors.")
      .key("contact", &RobotInFile::contact, contact_keys().value(), "Contact of bodies with the ground.");
}

}  // namespace lacuna
