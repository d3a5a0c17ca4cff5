#pragma once

#include <lacuna/robot_spec.h>
#include <lacuna/test.h>

#include <array>

namespace lacuna {

/// A quadruped of a torso, four upper and four lower legs on eight hinges with position servos, four touch and four
/// knee sensors; soft ground. The numbers that its other implementation needs too.
struct QuadrupedNumbers {
  double step = 0.01;                                     // s
  double gravity = 9.8;                                   // m/s²
  double leg_radius = 0.1, leg_length = 1.5;              // m
  double torso_radius = 0.2, hip_height = 0.85;           // m
  double knee_height = 1.6;                               // m
  double mass = 1.0;                                      // kg, of each body
  double stop = 0.5235987755982988;                       // rad, 30°
  double kp = 800.0, kd = 100.0, torque = 40.0;           // N·m/rad, N·m·s/rad, N·m: speed gain 8
  double ground_stiffness = 2e4, ground_damping = 300.0;  // N/m, N·s/m
};

inline constexpr int kLegs = 4;
inline constexpr std::array<std::array<double, 2>, kLegs> kLegSigns{{{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};

/// Moments of inertia of a solid cylinder along z.
InertiaSpec cylinder_inertia(double mass, double radius, double length);

/// Bodies: torso, then per leg upper, lower. Joints and actuators: per leg hip, knee.
/// Sensors: per leg touch, knee angle; last the torso's position.
RobotSpec quadruped_for_bench(const QuadrupedNumbers& numbers);

/// What servo `joint` is told at `time`, rad: a walk of a kind.
double quadruped_command(std::size_t joint, double time);

}  // namespace lacuna
