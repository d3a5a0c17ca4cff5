#include "flap.h"

#include "bench/bench_noise.h"
#include "bench/signals.h"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace damped_flap {
namespace {

using bench::ramp;
using bench::rounded;
using bench::Tone;
using std::numbers::pi;

constexpr int kKnotsASample = 8;  ///< the disturbance is linear between knots 0.5 ms apart
constexpr int kStepsAKnot = 25;   ///< integration steps of 20 µs
constexpr double kKnotInterval = kSampleInterval / kKnotsASample;
constexpr double kStep = kKnotInterval / kStepsAKnot;

double acceleration(const Truth& truth, const Motion& at, double torque) {
  const double lever_arm = truth.damper_radius * std::sin(at.angle / 2);
  const double damping = truth.damping + truth.damper * lever_arm * lever_arm;
  return (torque - truth.gravity_torque * std::sin(at.angle) - damping * at.velocity) / truth.inertia;
}

/// Slow, then near the natural frequency of about 0.9 Hz, where swings are large and fast.
double swings(double time) {
  const double large = ramp(time - 3.0, 0.3);
  return std::lerp(0.8 * ramp(time, 0.6) * std::sin(2.0 * pi * 0.4 * time),
                   0.28 * std::sin(2.0 * pi * 0.85 * (time - 3.0)), large);
}

double multisine(double time) {
  constexpr std::array kTones = {Tone{0.28, 0.2, 0.6}, Tone{0.24, 0.45, 2.4}, Tone{0.11, 0.8, 4.3},
                                 Tone{0.11, 1.1, 1.0}, Tone{0.18, 1.6, 5.0},  Tone{0.18, 2.1, 3.3}};
  return ramp(time, 0.6) * bench::multitone(kTones, time);
}

/// Levels held for 0.75 s, each reached within 50 ms.
double steps(double time) {
  constexpr std::array kLevels = {0.0, 0.45, -0.25, 0.5, 0.0, -0.55, -0.1, 0.35, -0.2};
  return bench::held_levels(kLevels, 0.75, time);
}

}  // namespace

std::vector<double> excitation(const std::string& trial, const Truth& truth) {
  double (*torque)(double) = trial == "swings"      ? swings
                             : trial == "multisine" ? multisine
                             : trial == "steps"     ? steps
                                                    : nullptr;
  if (torque == nullptr) throw std::invalid_argument("no trial is called " + trial);
  std::vector<double> commands(static_cast<std::size_t>(std::lround(kDuration / kSampleInterval)) + 1, 0.0);
  for (std::size_t k = 0; k < commands.size(); ++k) {
    const double time = static_cast<double>(k) * kSampleInterval - kRest;
    if (time > 0.0) commands[k] = rounded(torque(time), truth.command_quantum);
  }
  return commands;
}

Motion advance(const Truth& truth, const Motion& from, double start, double slope, double h) {
  const double middle = start + slope * h / 2, end = start + slope * h;
  const double q1 = from.velocity, v1 = acceleration(truth, from, start);
  const double q2 = from.velocity + h / 2 * v1, v2 = acceleration(truth, {from.angle + h / 2 * q1, q2}, middle);
  const double q3 = from.velocity + h / 2 * v2, v3 = acceleration(truth, {from.angle + h / 2 * q2, q3}, middle);
  const double q4 = from.velocity + h * v3, v4 = acceleration(truth, {from.angle + h * q3, q4}, end);
  return {from.angle + h / 6 * (q1 + 2 * q2 + 2 * q3 + q4), from.velocity + h / 6 * (v1 + 2 * v2 + 2 * v3 + v4)};
}

std::vector<bench::Row> record(const std::vector<double>& commands, const Truth& truth, std::uint64_t seed) {
  const double encoder_step = 2.0 * pi / truth.encoder_counts;
  bench::Disturbance disturbance(truth.disturbance, truth.disturbance_time, kKnotInterval, 2 * seed);
  bench::Normal sensor(2 * seed + 1);
  Motion motion;
  std::vector<bench::Row> rows;
  rows.reserve(commands.size());
  for (std::size_t k = 0; k < commands.size(); ++k) {
    const double reading = motion.angle + truth.sensor_noise * sensor();
    rows.push_back({static_cast<double>(k) * kSampleInterval, commands[k], rounded(reading, encoder_step)});
    for (int knot = 0; knot < kKnotsASample; ++knot) {
      const double before = disturbance.value();
      disturbance.next();
      const double slope = (disturbance.value() - before) / kKnotInterval;
      for (int i = 0; i < kStepsAKnot; ++i)
        motion = advance(truth, motion, commands[k] + before + slope * kStep * i, slope, kStep);
    }
  }
  return rows;
}

std::string recording_file(const std::string& trial) {
  const Truth truth;
  return bench::recording_text(record(excitation(trial, truth), truth, bench::noise_seed(trial)));
}

}  // namespace damped_flap
