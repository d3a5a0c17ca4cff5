#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <limits>
#include <string>
#include <vector>

namespace lacuna {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A robot as plain data: what a `RobotDefinition` makes and an engine compiles.
/// SI units, radians; world frame z up, x forward, y left. All poses and anchors are
/// those of the zero configuration, in which every joint position is zero.

/// The name of the parent where a joint fixes its child to the world.
inline constexpr const char* kWorld = "world";

enum class ShapeKind { box, sphere, capsule, cylinder };

/// A collision shape fixed to a body. Capsules and cylinders lie along their own z.
struct ShapeSpec {
  ShapeKind kind = ShapeKind::box;
  Eigen::Vector3d size{
      0.0, 0.0,
      0.0};  ///< box: edge lengths; sphere: radius; capsule, cylinder: radius, length (a capsule's without its caps); m
  Eigen::Vector3d position{0.0, 0.0, 0.0};                          ///< in the body frame, m
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< shape to body
};

/// Moments of inertia about the centre of mass, along the body's axes, kg·m².
struct InertiaSpec {
  double xx = 1.0, yy = 1.0, zz = 1.0;
  double xy = 0.0, xz = 0.0, yz = 0.0;
};

struct BodySpec {
  std::string name;
  double mass = 1.0;                   ///< kg
  Eigen::Vector3d com{0.0, 0.0, 0.0};  ///< centre of mass in the body frame, m
  InertiaSpec inertia;
  bool inertia_scales_with_mass = true;                             ///< setting only the mass scales `inertia` with it
  Eigen::Vector3d position{0.0, 0.0, 0.0};                          ///< origin of the body frame in the world, m
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< body to world
  std::vector<ShapeSpec> shapes;                                    ///< empty: touches nothing
};

enum class JointKind { hinge, slider, fixed, ball, universal, free };

/// A joint between `parent` and `child`. Hinge and slider have one coordinate (rad, m),
/// a universal joint two, a ball joint three (rotation vector of child relative to parent,
/// in the parent frame); positive is right-handed about, or along, the axis, child relative
/// to parent. The laws below act on each coordinate; a ball joint has no stops. A free joint holds nothing: it gives a
/// body that floats in the world six coordinates, so that its start can be stated and measured. They are the
/// displacement of the centre of mass (x, y, z, m) and the rotation vector (rad) from the zero configuration, world
/// frame; their rates the velocity of the centre of mass and the angular velocity. It has no laws.
struct JointSpec {
  std::string name;
  JointKind kind = JointKind::hinge;
  std::string parent = kWorld;
  std::string child;
  Eigen::Vector3d anchor{0.0, 0.0, 0.0};  ///< in the world, m
  Eigen::Vector3d axis{0.0, 1.0, 0.0};    ///< unit vector in the world
  Eigen::Vector3d axis2{1.0, 0.0, 0.0};   ///< universal joints: the child's axis, perpendicular to `axis`
  double lower = -kInfinity;              ///< stop, rad or m
  double upper = kInfinity;
  double damping = 0.0;       ///< −b·v, N·m·s/rad or N·s/m
  double dry_friction = 0.0;  ///< −Fc·sgn v with stiction, N·m or N
  double stiffness = 0.0;     ///< −k·(q − rest), N·m/rad or N/m
  double rest = 0.0;          ///< rad or m
  double armature = 0.0;      ///< inertia added to the joint's own coordinate, kg·m² or kg
  double force = 0.0;         ///< constant generalised force, N·m or N
};

/// The transmission between a motor and its joint. A rigid one (infinite stiffness) reflects `rotor_inertia`·ratio² to
/// the joint; with finite stiffness the rotor has its own state.
struct TransmissionSpec {
  double ratio = 1.0;            ///< motor turns per joint turn
  double rotor_inertia = 0.0;    ///< at the motor shaft, kg·m² (kg on a slider)
  double stiffness = kInfinity;  ///< joint side, N·m/rad or N/m
  double damping = 0.0;          ///< joint side, N·m·s/rad or N·s/m
  double gap = 0.0;              ///< full backlash width at the joint, rad or m
};

enum class ActuatorKind {
  force,           ///< command is the force or torque
  velocity_servo,  ///< command is a velocity; torque = kd·(command − v)
  position_servo,  ///< command is a position; torque = kp·(command − q) − kd·v
  pid,             ///< command is a position; adds ki·∫(command − q)dt; kd acts on the error
  voltage,  ///< command is a voltage U on a motor; torque = kt·(U − back_emf·kt·v)/R, |U| ≤ duty_limit·supply
  voltage_servo,  ///< command is a position; the same of the voltage duty·supply, |duty| ≤ duty_limit, where
                  ///< duty = gain_unit·(kp·(command − q) − kd·v)
  motion          ///< command is a velocity that is imposed on the joint with any force that this needs
};

/// A motor driven by a voltage; all values at the joint, including the transmission.
struct MotorSpec {
  double torque_constant = 0.0;  ///< kt, N·m/A or N/A
  double resistance = 1.0;       ///< R, Ohm
  double back_emf = 1.0;         ///< voltage per velocity over the torque constant; 1: no losses in between
  double supply = kInfinity;     ///< V; a servo's must be finite
  double duty_limit = 1.0;       ///< largest share of the supply voltage that the driver can apply
  double gain_unit = 1.0;        ///< meaning of one count of a servo's kp: share of the supply voltage per rad or m
  /// s; interval at which a servo reads its position and updates the voltage; 0: continuously.
  double sample_time = 0.0;
};

struct ActuatorSpec {
  std::string name;
  std::string joint;  ///< a hinge, a slider, or a universal joint, whose first coordinate it drives
  ActuatorKind kind = ActuatorKind::force;
  double gain = 1.0;               ///< multiplies the command first
  bool relative = false;           ///< the command has no unit: `gain` converts a share of 1 into a position or force
  double offset = 0.0;             ///< added to the command after the gain, in its unit
  double delay = 0.0;              ///< s
  double kp = 0.0;                 ///< N·m/rad or N/m
  double ki = 0.0;                 ///< N·m/(rad·s) or N/(m·s)
  double kd = 0.0;                 ///< N·m·s/rad or N·s/m
  double force_limit = kInfinity;  ///< joint side, N·m or N
  double command_lower = -kInfinity;  ///< commands are clipped to this range
  double command_upper = kInfinity;
  /// The supply sags: with P, the force that the actuator would exert at rest on a supply that does not sag, the force
  /// is (P − back-EMF part)/(1 + supply_sag·|P|); 1/(N·m) or 1/N. Not of kind motion.
  double supply_sag = 0.0;
  TransmissionSpec transmission;
  MotorSpec motor;  ///< for the kinds voltage and voltage_servo
};

enum class SensorKind {
  joint_position,         ///< rad or m, counting turns
  joint_velocity,         ///< rad/s or m/s
  joint_force,            ///< of actuators and joint laws along the coordinate in the last step (0 at first), N·m or N
  touch,                  ///< +1 while the body touches the ground, −1 otherwise
  body_position,          ///< of the body frame's origin, world, m: x, y, z
  body_velocity,          ///< of that origin, world, m/s: x, y, z
  body_orientation,       ///< body to world, quaternion w, x, y, z with w ≥ 0
  body_angular_velocity,  ///< world, rad/s: x, y, z
  beacon_range,           ///< distance of the body frame's origin to `beacon`, m
  contact_force,          ///< force of the ground on the body in the last step (0 at first), world, N: x, y, z
  drive_force,            ///< of actuators alone along the coordinate in the last step (0 at first), N·m or N
  link_angle,             ///< angle of a hinge's child about its axis, from the zero configuration, counting turns, rad
  link_velocity,          ///< its rate, rad/s
  accelerometer  ///< acceleration of the point `at` of a body minus gravity, along the body's axes, over the last step
                 ///< (at first as if at rest), m/s²: x, y, z
};

/// A sensor reads `element` (a joint's or a body's name). Its channels are called by its
/// name, or `name.x`, `name.y` ... where it has several. Order of stages: true value, delay,
/// effects, scale, offset, noise, quantisation.
struct SensorSpec {
  std::string name;
  SensorKind kind = SensorKind::joint_position;
  std::string element;
  Eigen::Vector3d beacon{0.0, 0.0, 0.0};  ///< world, m
  Eigen::Vector3d at{0.0, 0.0, 0.0};      ///< position of an accelerometer in the body frame, m
  double delay = 0.0;                     ///< s; before the start the initial value is read
  double scale = 1.0;
  bool relative = false;  ///< the channels have no unit: `scale` converts the quantity into a share of 1
  double offset = 0.0;    ///< in the channel's unit
  double noise = 0.0;     ///< standard deviation of white noise, channel's unit
  double quantum = 0.0;   ///< step of the quantiser, channel's unit; 0: none
};

/// Contact of bodies with the ground, a spring–damper of the given constants with a
/// Coulomb friction cone.
struct ContactSpec {
  bool ground = false;           ///< whether there is a ground plane z = 0 (tilted by `slope`)
  double stiffness = kInfinity;  ///< N/m, infinite: rigid
  double damping = 0.0;          ///< N·s/m
  double friction = kInfinity;   ///< Coulomb's μ, 1
  double slope = 0.0;            ///< ground rotated about y, rad; positive descends along +x
  double impact_damping = 0.0;   ///< damping force over elastic force, of a contact that is not rigid, s/m
  double restitution = 0.0;    ///< normal velocity after an impact over the velocity before, of a rigid contact, 0 to 1
  double rolling_lever = 0.0;  ///< largest moment against rolling over the normal force, m
  double creep = 0.0;          ///< sliding velocity per tangential force of a contact point, m/(N·s)
};

/// Two coordinates coupled by a gear, a belt or a linkage: q(joint) = ratio·q(follows) + offset. Both joints are hinges
/// or sliders; a joint that follows another must not be followed.
struct CouplingSpec {
  std::string name;
  std::string joint;
  std::string follows;
  double ratio = 1.0;   ///< 1, rad/m or m/rad
  double offset = 0.0;  ///< rad or m
};

struct RobotSpec {
  std::string name;
  std::vector<BodySpec> bodies;
  std::vector<JointSpec> joints;  ///< a forest: each body is the child of at most one joint; a body without one floats
  std::vector<ActuatorSpec> actuators;
  std::vector<SensorSpec> sensors;
  ContactSpec contact;
  Eigen::Vector3d gravity{0.0, 0.0, -9.81};  ///< m/s²
  std::vector<CouplingSpec> couplings = {};
};

}  // namespace lacuna
