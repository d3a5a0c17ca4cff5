#include "bench.h"

#include "bench/bench_noise.h"
#include "bench/signals.h"
#include "stick_slip.h"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace servo_pendulum {
namespace {

using bench::ramp;
using bench::rounded;
using bench::Tone;
using std::numbers::pi;

constexpr int kKnotsASample = 4;  ///< the disturbance is linear between knots 0.5 ms apart
constexpr int kStepsAKnot = 50;   ///< integration steps of 10 µs
constexpr double kKnotInterval = kSampleInterval / kKnotsASample;

double sine(double time) { return 0.42 * ramp(time, 1.0) * std::sin(2.0 * pi * 0.4 * time); }

/// Levels held for 0.7 s, each reached within 50 ms.
double steps(double time) {
  constexpr std::array kLevels = {0.0, 0.25, -0.15, 0.35, 0.1, -0.3, -0.05, 0.2, -0.25, 0.05, 0.3, 0.0};
  return bench::held_levels(kLevels, 0.7, time);
}

double multisine(double time) {
  constexpr std::array kTones = {Tone{0.16, 0.15, 0.4}, Tone{0.14, 0.35, 2.1}, Tone{0.09, 0.65, 4.0},
                                 Tone{0.08, 1.2, 1.3},  Tone{0.14, 1.7, 5.2},  Tone{0.16, 2.3, 3.1}};
  return ramp(time, 0.8) * bench::multitone(kTones, time);
}

/// From 0.1 Hz to 2.2 Hz, weaker around the arm's natural frequency of about 0.9 Hz.
double chirp(double time) {
  constexpr double kFirst = 0.1, kLast = 2.2, kLength = kDuration - kRest;
  const double frequency = kFirst + (kLast - kFirst) * time / kLength;
  const double phase = 2.0 * pi * (kFirst * time + 0.5 * (kLast - kFirst) * time * time / kLength);
  const double notch = 1.0 - 0.6 * std::exp(-std::pow((frequency - 0.9) / 0.35, 2));
  return 0.45 * ramp(time, 0.5) * notch * std::sin(phase);
}

}  // namespace

std::vector<double> excitation(const std::string& trial, const Truth& truth) {
  double (*torque)(double) = trial == "sine"        ? sine
                             : trial == "steps"     ? steps
                             : trial == "multisine" ? multisine
                             : trial == "chirp"     ? chirp
                                                    : nullptr;
  if (torque == nullptr) throw std::invalid_argument("no trial is called " + trial);
  std::vector<double> commands(static_cast<std::size_t>(std::lround(kDuration / kSampleInterval)) + 1, 0.0);
  for (std::size_t k = 0; k < commands.size(); ++k) {
    const double time = static_cast<double>(k) * kSampleInterval - kRest;
    if (time > 0.0) commands[k] = rounded(torque(time), truth.command_quantum);
  }
  return commands;
}

std::vector<bench::Row> record(const std::vector<double>& commands, const Truth& truth, std::uint64_t seed) {
  const Pendulum pendulum{truth.inertia, truth.gravity_torque, truth.damping, truth.friction};
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
      for (int i = 0; i < kStepsAKnot; ++i) {
        const double since = kKnotInterval * i / kStepsAKnot;
        motion = advance(pendulum, motion, {commands[k] + before + slope * since, slope}, kKnotInterval / kStepsAKnot);
      }
    }
  }
  return rows;
}

}  // namespace servo_pendulum
