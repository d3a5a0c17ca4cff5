#pragma once

namespace servo_pendulum {

/// A pendulum with Coulomb friction under a torque that is linear in time.
struct Pendulum {
  double inertia = 1.0;         ///< kg·m²
  double gravity_torque = 0.0;  ///< N·m at 90°
  double damping = 0.0;         ///< N·m·s/rad
  double friction = 0.0;        ///< N·m
};

/// torque(t) = start + slope·t for t in [0, duration].
struct LinearTorque {
  double start = 0.0;  ///< N·m
  double slope = 0.0;  ///< N·m/s
  double at(double time) const { return start + slope * time; }
};

struct Motion {
  double angle = 0.0;     ///< rad
  double velocity = 0.0;  ///< rad/s, exactly zero while the arm sticks
};

/// Carries the motion on by `duration`, which is one integration step: classical Runge–Kutta of
/// fourth order while the arm slides. Where it stops, reverses or breaks away within the step, the
/// step is split at that instant, so that no stretch is integrated across a corner of the friction law.
Motion advance(const Pendulum& pendulum, Motion motion, const LinearTorque& torque, double duration);

}  // namespace servo_pendulum
