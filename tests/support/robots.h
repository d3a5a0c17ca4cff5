#pragma once

#include <lacuna/robot_spec.h>

#include <string>

/// Small robots with textbook equations of motion.
namespace lacuna {

/// A body without shapes, its inertia the same about all axes.
BodySpec plain_body(const std::string& name, double mass, double inertia);

SensorSpec make_sensor(const std::string& name, SensorKind kind, const std::string& element);

/// A joint named `joint` from the world to a body `body`, axis and inertia as given, sensors `position`,
/// `velocity` and `force` of the joint, an actuator `motor` of kind `force`. No gravity.
/// Hinge: the body's centre of mass lies on the axis (`inertia` about it, kg·m²); slider: `inertia` is the mass, kg.
RobotSpec one_joint(JointKind kind, double inertia, const Eigen::Vector3d& axis = Eigen::Vector3d::UnitY());

inline constexpr double kGravity = 9.81;  ///< m/s²

/// A rigid pendulum: hinge `joint` about y at the origin, a body `body` of `mass` that hangs `length` below,
/// with moment of inertia `inertia` about its own centre. Sensors as above.
RobotSpec pendulum(double mass, double length, double inertia);
/// (d²q/dt²)/(−sin q) of such a pendulum, 1/s².
double pendulum_rate(double mass, double length, double inertia);

/// Two such links in a row, hinges `upper` and `lower` about y, sensors `q1`, `v1`, `q2`, `v2`; q2 is relative to q1.
RobotSpec double_pendulum(double mass, double length, double inertia);

/// Links of 0.5 kg and 0.2 m that hang one below the other on hinges `j1`, `j2`, ... about y, each with a motor `m1`,
/// ... and an encoder `q1`, ...
RobotSpec driven_chain(std::size_t links);

/// A body `body` that floats, with sensors `position`, `velocity`, `orientation`, `spin` of it.
RobotSpec floating_body(double mass, const InertiaSpec& inertia);

}  // namespace lacuna
