#include "servo.h"

#include "bench/bench_noise.h"
#include "bench/recording.h"
#include "bench/signals.h"
#include "stick_slip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>

namespace lifting_servo {
namespace {

using bench::ramp;
using bench::rounded;
using bench::Tone;
using std::numbers::pi;

constexpr double kGravity = 9.81;       // m/s²
constexpr int kStepsASample = 400;      // integration steps of 10 µs
constexpr double kGoalQuantum = 0.001;  // rad

/// Up to the horizontal, slowly and faster.
double waves(double time) {
  constexpr std::array kTones = {Tone{0.75, 0.22, 0.4}, Tone{0.45, 0.51, 2.1}, Tone{0.2, 1.3, 4.0}};
  return ramp(time, 0.8) * (0.5 + bench::multitone(kTones, time));
}

/// Goals held for 0.6 s, each reached within 50 ms.
double steps(double time) {
  constexpr std::array kLevels = {0.0, 0.9, 1.4, 0.5, -0.6, -1.2, 0.2, 1.1, 0.0, -0.8};
  return bench::held_levels(kLevels, 0.6, time);
}

}  // namespace

double weight_of(const std::string& trial) { return trial.starts_with("light") ? 0.1 : 0.35; }

std::vector<double> goals(const std::string& trial) {
  double (*goal)(double) = trial.ends_with("waves") ? waves : trial.ends_with("steps") ? steps : nullptr;
  if (goal == nullptr) throw std::invalid_argument("no trial is called " + trial);
  std::vector<double> goals(static_cast<std::size_t>(std::lround(kDuration / kSampleInterval)) + 1, 0.0);
  for (std::size_t k = 0; k < goals.size(); ++k) {
    const double time = static_cast<double>(k) * kSampleInterval - kRest;
    if (time > 0.0) goals[k] = rounded(goal(time), kGoalQuantum);
  }
  return goals;
}

std::vector<double> record(const std::vector<double>& goals, double weight, const Truth& truth, std::uint64_t seed) {
  const double arm = truth.arm_mass * truth.arm_length * truth.arm_length / 3.0;
  const double lever = (weight + 0.5 * truth.arm_mass) * truth.arm_length;
  const double per_volt = truth.constant / truth.resistance, drag = truth.constant * per_volt;
  servo_pendulum::Pendulum pendulum{.inertia = truth.armature + arm + weight * truth.arm_length * truth.arm_length,
                                    .gravity_torque = lever * kGravity,
                                    .damping = drag};
  bench::Normal sensor(seed);
  servo_pendulum::Motion motion;
  std::vector<double> readings;
  readings.reserve(goals.size());
  for (const double goal : goals) {
    readings.push_back(rounded(motion.angle + truth.sensor_noise * sensor(), 2.0 * pi / truth.encoder_counts));
    const double duty = std::clamp(truth.gain * truth.kp * (goal - motion.angle), -truth.duty_limit, truth.duty_limit);
    const double push = per_volt * duty * truth.supply;
    for (int i = 0; i < kStepsASample; ++i) {
      pendulum.friction = truth.load_friction * std::abs(push - drag * motion.velocity);
      motion = servo_pendulum::advance(pendulum, motion, {push, 0.0}, kSampleInterval / kStepsASample);
    }
  }
  return readings;
}

std::string recording_file(const std::string& trial) {
  const std::vector<double> commands = goals(trial);
  const std::vector<double> angles = record(commands, weight_of(trial), {}, bench::noise_seed(trial));
  std::string text = "t_s,goal_rad,angle_deg\n";
  for (std::size_t k = 0; k < commands.size(); ++k) {
    char line[96];
    std::snprintf(line, sizeof line, "%.3f,%.3f,%.5f\n", static_cast<double>(k) * kSampleInterval, commands[k],
                  angles[k] * 180.0 / pi);
    text += line;
  }
  return text;
}

}  // namespace lifting_servo
