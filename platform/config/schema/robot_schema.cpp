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
    reading.problem(node, "a direction of length zero points nowhere");
    return false;
  };
  return either(letter, numbers);
}

Value<InertiaSpec> inertia() {
  const auto moment = number("kg*m^2").above(0.0);
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
      .key("along", &ShapeInFile::along, direction(), "where the shape's own z points, in the body frame")
      .key("rpy", &ShapeInFile::rpy, vector3("rad"), "instead of along: turned about the body's x, then y, then z")
      .key("mass", &ShapeInFile::mass, number("kg").above(0.0), "from which the body's mass and inertia follow")
      .key("density", &ShapeInFile::density, number("kg/m^3").above(0.0), "instead of mass")
      .key("collides", &ShapeInFile::collides, boolean(), "false: it has mass, but touches nothing");
}

Table<BodyInFile> body_keys() {
  const Table<BodySpec> spec =
      Table<BodySpec>()
          .key("at", &BodySpec::position, vector3("m"), "origin of the body frame in the world, all joints at zero")
          .key("rpy", &BodySpec::orientation, orientation(), "turned about the world's x, then y, then z")
          .key("inertia_scales_with_mass", &BodySpec::inertia_scales_with_mass, boolean(),
               "setting or fitting the mass alone scales the inertia with it");
  return Table<BodyInFile>()
      .merged(&BodyInFile::spec, spec)
      .key("mass", &BodyInFile::mass, number("kg").above(0.0), "without it, the sum of its shapes")
      .key("com", &BodyInFile::com, vector3("m"), "centre of mass in the body frame; without it, that of the shapes")
      .key("inertia", &BodyInFile::inertia, inertia(),
           "about the centre of mass, along the body's axes; without it, that of the shapes")
      .key("shapes", &BodyInFile::shapes, list_of(shape_keys().value()),
           "What touches the ground, and where mass and inertia follow from.");
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
           "what it lets move")
      .key("parent", &JointSpec::parent, element_name(), "a body, or \"world\"")
      .required("child", &JointSpec::child, element_name(), "the body that it holds")
      .key("axis", &JointSpec::axis, direction(), "in the world, all joints at zero; positive is right-handed about it")
      .key("lower", &JointSpec::lower, NumberValue(position).or_infinite(), "stop")
      .key("upper", &JointSpec::upper, NumberValue(position).or_infinite(), "stop")
      .key("damping", &JointSpec::damping, number("N*m*s/rad or N*s/m").at_least(0.0), "viscous friction")
      .key("dry_friction", &JointSpec::dry_friction, number("N*m or N").at_least(0.0), "Coulomb friction")
      .key("stiffness", &JointSpec::stiffness, number("N*m/rad or N/m").at_least(0.0), "of a spring to rest")
      .key("rest", &JointSpec::rest, position, "where that spring is at rest")
      .key("armature", &JointSpec::armature, number("kg*m^2 or kg").at_least(0.0), "inertia added to the coordinate")
      .key("force", &JointSpec::force, number("N*m or N"), "constant force or torque");
}

Table<JointInFile> joint_keys() {
  return Table<JointInFile>()
      .merged(&JointInFile::spec, joint_law_keys())
      .key("anchor", &JointInFile::anchor, vector3("m"),
           "in the world, all joints at zero; without it, the child's origin")
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
           "torque at the joint per current")
      .key("resistance", &MotorSpec::resistance, number("Ohm").above(0.0), "of the winding and its driver")
      .key("back_emf", &MotorSpec::back_emf, number("1").at_least(0.0),
           "voltage per joint velocity over the torque constant; 1: nothing is lost in between")
      .key("supply", &MotorSpec::supply, number("V").above(0.0).or_infinite(),
           "voltage of the supply; a servo needs it")
      .key("duty_limit", &MotorSpec::duty_limit, number("1").above(0.0),
           "largest share of the supply that the driver puts out")
      .key("gain_unit", &MotorSpec::gain_unit, number("1/rad or 1/m").above(0.0),
           "of a servo: share of the supply per rad or m that one count of kp stands for")
      .key("sample_time", &MotorSpec::sample_time, number("s").at_least(0.0),
           "of a servo: it reads its position so often, at whole integration steps, and holds the voltage in between; "
           "0: at "
           "all times");
}

Table<ActuatorSpec> actuator_keys() {
  const std::string command = "";  // force, velocity or position: the kind decides
  return Table<ActuatorSpec>()
      .required("joint", &ActuatorSpec::joint, element_name(), "the joint that it drives")
      .key("kind", &ActuatorSpec::kind,
           choice<ActuatorKind>({{"force", ActuatorKind::force},
                                 {"velocity_servo", ActuatorKind::velocity_servo},
                                 {"position_servo", ActuatorKind::position_servo},
                                 {"pid", ActuatorKind::pid},
                                 {"voltage", ActuatorKind::voltage},
                                 {"voltage_servo", ActuatorKind::voltage_servo},
                                 {"motion", ActuatorKind::motion}}),
           "what a command means: a force, a velocity, a position (both servos and pid), a voltage on a motor, a "
           "position "
           "that a servo reaches by a voltage on its motor, or motion: the velocity that is imposed on the joint")
      .key("gain", &ActuatorSpec::gain, number("1"), "multiplies the command before anything else")
      .key("relative", &ActuatorSpec::relative, boolean(),
           "the command has no unit; the gain makes a position or force of a share of 1")
      .key("offset", &ActuatorSpec::offset, number(command), "added to the command after the gain")
      .key("delay", &ActuatorSpec::delay, number("s").at_least(0.0), "of the command")
      .key("kp", &ActuatorSpec::kp, number("N*m/rad or N/m").at_least(0.0),
           "of position servo and pid; of a voltage servo in counts of its own (motor.gain_unit)")
      .key("ki", &ActuatorSpec::ki, number("N*m/(rad*s) or N/(m*s)").at_least(0.0), "of pid")
      .key("kd", &ActuatorSpec::kd, number("N*m*s/rad or N*s/m").at_least(0.0),
           "of servos and pid; of a voltage servo in counts and s")
      .key("force_limit", &ActuatorSpec::force_limit, number("N*m or N").at_least(0.0).or_infinite(), "at the joint")
      .key("command_lower", &ActuatorSpec::command_lower, number(command).or_infinite(), "commands are clipped to this")
      .key("command_upper", &ActuatorSpec::command_upper, number(command).or_infinite(), "commands are clipped to this")
      .key("transmission", &ActuatorSpec::transmission, transmission_keys().value(),
           "What lies between motor and joint.")
      .key("motor", &ActuatorSpec::motor, motor_keys().value(), "Of kinds voltage and voltage_servo: the motor.");
}

Table<CouplingSpec> coupling_keys() {
  return Table<CouplingSpec>()
      .required("joint", &CouplingSpec::joint, element_name(), "a hinge or slider that follows another")
      .required("follows", &CouplingSpec::follows, element_name(), "the hinge or slider that it follows")
      .key("ratio", &CouplingSpec::ratio, number("1, rad/m or m/rad"), "of its coordinate to the other's")
      .key("offset", &CouplingSpec::offset, number("rad or m"), "its coordinate where the other's is zero");
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
                    "what it reads")
          .key("beacon", &SensorSpec::beacon, vector3("m"),
               "of beacon_range: the place from which distance is measured")
          .key("at", &SensorSpec::at, vector3("m"), "of accelerometer: where it is, in the body's frame")
          .key("delay", &SensorSpec::delay, number("s").at_least(0.0), "before the start the initial value is read")
          .key("scale", &SensorSpec::scale, number("1"), "multiplies the reading")
          .key("relative", &SensorSpec::relative, boolean(),
               "the channels have no unit; the scale makes a share of 1 of what is read")
          .key("offset", &SensorSpec::offset, number(channel), "added after the scale")
          .key("noise", &SensorSpec::noise, number(channel).at_least(0.0), "standard deviation of white noise")
          .key("quantum", &SensorSpec::quantum, number(channel).at_least(0.0), "step of the quantiser; 0: none");
  return Table<SensorInFile>()
      .merged(&SensorInFile::spec, spec)
      .key("joint", &SensorInFile::joint, element_name(),
           "the joint that a joint_*, drive_* or link_* sensor reads: joint_* against its parent, link_* against the "
           "world")
      .key("body", &SensorInFile::body, element_name(), "the body that any other sensor reads");
}

Table<ContactSpec> contact_keys() {
  return Table<ContactSpec>()
      .key("ground", &ContactSpec::ground, boolean(), "is there a ground plane z = 0?")
      .key("stiffness", &ContactSpec::stiffness, number("N/m").above(0.0).or_infinite(), "inf: rigid")
      .key("damping", &ContactSpec::damping, number("N*s/m").at_least(0.0), "of the contact")
      .key("friction", &ContactSpec::friction, number("1").at_least(0.0).or_infinite(), "Coulomb's coefficient")
      .key("slope", &ContactSpec::slope, number("rad").between(-1.5, 1.5),
           "ground turned about y; positive descends along x");
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
      .section("robot", head, "What the robot is called.", true)
      .section("world", world, "What surrounds it.")
      .required("body", &RobotInFile::bodies,
                elements<BodyInFile>("BODY", body_keys(), [](BodyInFile& b) -> std::string& { return b.spec.name; }),
                "Rigid bodies. One that is no joint's child floats.")
      .key("joint", &RobotInFile::joints,
           elements<JointInFile>("JOINT", joint_keys(), [](JointInFile& j) -> std::string& { return j.spec.name; }),
           "Joints, each between a parent and a child.")
      .key("actuator", &RobotInFile::actuators,
           elements<ActuatorSpec>("ACTUATOR", actuator_keys(), [](ActuatorSpec& a) -> std::string& { return a.name; }),
           "What drives joints.")
      .key("coupling", &RobotInFile::couplings,
           elements<CouplingSpec>("COUPLING", coupling_keys(), [](CouplingSpec& c) -> std::string& { return c.name; }),
           "Gears, belts and linkages that hold two joints together: q(joint) = ratio * q(follows) + offset.")
      .key("sensor", &RobotInFile::sensors,
           elements<SensorInFile>("SENSOR", sensor_keys(), [](SensorInFile& s) -> std::string& { return s.spec.name; }),
           "What is read.")
      .key("contact", &RobotInFile::contact, contact_keys().value(), "Contact of bodies with the ground.");
}

}  // namespace lacuna
