#include "stick_slip.h"

#include <algorithm>
#include <cmath>

namespace servo_pendulum {
namespace {

constexpr double kEventResolution = 1e-12;  ///< s: moves the velocity at a stop by some 1e-11 rad/s

/// Sliding in the direction `sense` (±1), on which the friction depends; smooth, whatever the velocity does.
struct Slide {
  const Pendulum& pendulum;
  const LinearTorque& torque;
  double sense;

  double acceleration(double time, double angle, double velocity) const {
    const double driving = torque.at(time) - pendulum.gravity_torque * std::sin(angle);
    return (driving - pendulum.damping * velocity - sense * pendulum.friction) / pendulum.inertia;
  }

  Motion step(double time, const Motion& from, double h) const {
    const double q1 = from.velocity, v1 = acceleration(time, from.angle, from.velocity);
    const double q2 = from.velocity + h / 2 * v1, v2 = acceleration(time + h / 2, from.angle + h / 2 * q1, q2);
    const double q3 = from.velocity + h / 2 * v2, v3 = acceleration(time + h / 2, from.angle + h / 2 * q2, q3);
    const double q4 = from.velocity + h * v3, v4 = acceleration(time + h, from.angle + h * q3, q4);
    return {from.angle + h / 6 * (q1 + 2 * q2 + 2 * q3 + q4), from.velocity + h / 6 * (v1 + 2 * v2 + 2 * v3 + v4)};
  }

  /// Time until the velocity changes its sign, by bisection; `h` if it does not.
  double time_to_stop(double time, const Motion& from, double h) const {
    if (sense * step(time, from, h).velocity > 0.0) return h;
    double slides = 0.0, stopped = h;
    while (stopped - slides > kEventResolution) {
      const double middle = (slides + stopped) / 2;
      (sense * step(time, from, middle).velocity > 0.0 ? slides : stopped) = middle;
    }
    return stopped;
  }
};

/// What friction has to balance if the arm rests.
double load_at_rest(const Pendulum& pendulum, double angle, double torque) {
  return torque - pendulum.gravity_torque * std::sin(angle);
}

/// When in [time, duration] the resting arm breaks away; `duration` if it does not.
double time_of_break_away(const Pendulum& pendulum, double angle, const LinearTorque& torque, double time,
                          double duration) {
  const double last = load_at_rest(pendulum, angle, torque.at(duration));
  if (std::abs(load_at_rest(pendulum, angle, torque.at(time))) > pendulum.friction) return time;
  if (std::abs(last) <= pendulum.friction) return duration;
  const double limit = std::copysign(pendulum.friction, last);
  const double crossing = (limit + pendulum.gravity_torque * std::sin(angle) - torque.start) / torque.slope;
  return std::clamp(crossing, time, duration);
}

}  // namespace

Motion advance(const Pendulum& pendulum, Motion motion, const LinearTorque& torque, double duration) {
  double time = 0.0;
  while (time < duration) {
    double sense = motion.velocity > 0.0 ? 1.0 : -1.0;
    if (motion.velocity == 0.0) {
      time = time_of_break_away(pendulum, motion.angle, torque, time, duration);
      if (time >= duration) return motion;
      sense = std::copysign(1.0, load_at_rest(pendulum, motion.angle, torque.at(time)));
    }
    const Slide slide{pendulum, torque, sense};
    const double stretch = slide.time_to_stop(time, motion, duration - time);
    motion = slide.step(time, motion, stretch);
    time += stretch;
    if (sense * motion.velocity <= 0.0) motion.velocity = 0.0;
  }
  return motion;
}

}  // namespace servo_pendulum
