#pragma once

#include "bench/recording.h"

#include <cstdint>
#include <string>
#include <vector>

/// A servo pendulum bench as it "really" is: the truth behind the recordings in this folder. Nothing of Lacuna reads
/// this file; the recordings and the experiment that fits them know only what a bench's owner would know.
namespace servo_pendulum {

/// inertia·q'' + damping·q' + friction·sgn q' + gravity_torque·sin q = command + disturbance, q = 0 hanging.
/// At rest the friction is whatever holds the arm still, up to `friction`.
struct Truth {
  double inertia = 0.031;           ///< about the hinge, arm and rotor together, kg·m²
  double gravity_torque = 1.05;     ///< mass × g × distance of its centre from the hinge, N·m
  double damping = 0.021;           ///< N·m·s/rad
  double friction = 0.024;          ///< Coulomb friction of the hinge, N·m: what the model lacks
  double disturbance = 5e-4;        ///< unmodelled random torque: standard deviation, N·m ...
  double disturbance_time = 0.02;   ///< ... and correlation time, s (Ornstein–Uhlenbeck)
  double sensor_noise = 3e-4;       ///< standard deviation of white noise on the angle, rad
  int encoder_counts = 2048;        ///< a turn
  double command_quantum = 0.0005;  ///< resolution of the torque command, N·m
};

inline constexpr double kSampleInterval = 0.002;  ///< s; commands are held in between
inline constexpr double kDuration = 8.0;          ///< s, of each recording
inline constexpr double kRest = 0.3;              ///< s without command at the start of each recording

/// Torque commands, one a sample: "sine", "steps", "multisine" or "chirp".
std::vector<double> excitation(const std::string& trial, const Truth& truth);

/// Carries a trial out: equation of motion, disturbance, sensor noise and encoder. The same
/// `seed` gives the same noise.
std::vector<bench::Row> record(const std::vector<double>& commands, const Truth& truth, std::uint64_t seed);

}  // namespace servo_pendulum
