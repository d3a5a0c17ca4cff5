#pragma once

#include "bench/recording.h"

#include <string>
#include <vector>

/// A flap with an oil damper as it "really" is: the truth behind the recordings in this folder. Nothing of Lacuna reads
/// this file; the recordings and the experiment that fits them know only what the flap's owner would know.
namespace damped_flap {

/// inertia·q'' + damping·q' + gravity_torque·sin q = command + disturbance + damper_torque, q = 0 hanging.
///
/// The oil damper is pinned to the frame `damper_radius` above the hinge and to the flap `damper_radius` below it, at
/// q = 0 on one line through the hinge. Its length is 2·damper_radius·cos(q/2), its lever arm damper_radius·sin(q/2):
/// none where the flap hangs, more and more as it swings out to either side.
struct Truth {
  double inertia = 0.046;           ///< about the hinge, flap and rotor together, kg·m²
  double gravity_torque = 1.42;     ///< mass × g × distance of its centre from the hinge, N·m
  double damping = 0.026;           ///< of bearing and motor, N·m·s/rad
  double damper = 16.0;             ///< force of the oil damper over the speed of its rod, N·s/m ...
  double damper_radius = 0.10;      ///< ... and where it is pinned, m: what the model lacks
  double disturbance = 5e-4;        ///< unmodelled random torque: standard deviation, N·m ...
  double disturbance_time = 0.02;   ///< ... and correlation time, s (Ornstein–Uhlenbeck)
  double sensor_noise = 3e-4;       ///< standard deviation of white noise on the angle, rad
  int encoder_counts = 4096;        ///< a turn
  double command_quantum = 0.0005;  ///< resolution of the torque command, N·m
};

inline constexpr double kSampleInterval = 0.004;  ///< s; commands are held in between
inline constexpr double kDuration = 4.0;          ///< s, of each recording
inline constexpr double kRest = 0.3;              ///< s without command at the start of each recording

/// The recordings of this folder.
inline constexpr const char* kTrials[] = {"swings", "multisine", "steps"};

/// Torque commands of one of them, one a sample.
std::vector<double> excitation(const std::string& trial, const Truth& truth);

struct Motion {
  double angle = 0.0;     ///< rad
  double velocity = 0.0;  ///< rad/s
};

/// Carries the motion on by one step of `duration` s (classical Runge–Kutta of fourth order) under the torque
/// start + slope·t in N·m.
Motion advance(const Truth& truth, const Motion& from, double start, double slope, double duration);

/// Carries a trial out: equation of motion, disturbance, sensor noise and encoder. The same
/// `seed` gives the same noise.
std::vector<bench::Row> record(const std::vector<double>& commands, const Truth& truth, std::uint64_t seed);

/// The whole text of a trial's CSV file.
std::string recording_file(const std::string& trial);

}  // namespace damped_flap
