#pragma once

#include "dirty/true_trial.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hidden_effects::dirty {

/// How a rig is read and logged. By sensor: rad, m, rad/s, m/s, N·m or N.
struct Recording {
  std::vector<double> white;    ///< standard deviation, from sample to sample
  std::vector<double> lasting;  ///< standard deviation of an error that lasts and that nobody declares
  double lasting_time = 0.5;    ///< s, its correlation time
  std::vector<double> quantum;
  double jitter = 0.0;   ///< of the interval: how unevenly is sampled
  double receipt = 0.0;  ///< of the interval: mean delay of stamps that are given on receipt
  double drops = 0.0;    ///< share of the rows that are missing
  bool declares_noise = false, declares_quantum = false;
  bool two_devices = false;      ///< the first sensor has a file, a clock and a rate of its own
  double second_offset = 0.0;    ///< s, that its stamps are behind; the owner knows it
  double second_interval = 0.0;  ///< s
  std::string time_unit = "s", angle_unit = "rad", length_unit = "m";
  bool logs_reference = false;  ///< of a controller outside: what it was to follow
  double amperes = 0.0;         ///< N·m/A or N/A: forces are logged as currents; 0: as forces
};

/// A file of numbers.
struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;  ///< SI
};

struct RecordedTrial {
  std::string name;
  bool held_out = false;
  Table table;   ///< t, commands by drive, sensors, references by drive
  Table second;  ///< of the second device: t and the first sensor; empty without one
};

/// Draws how a rig is recorded. `range` and `speed`: of each sensor's readings and of their rate of change, RMS. What a
/// late stamp makes of a moving reading counts as white.
Recording draw_recording(const DirtyRig& rig, const std::vector<double>& range, const std::vector<double>& speed,
                         std::uint64_t seed);

/// Standard deviation of everything that is wrong with the readings, by sensor.
std::vector<double> reading_noise(const Recording& recording, const DirtyRig& rig, const std::vector<double>& speed);

/// A trial as it is logged.
RecordedTrial record(const DirtyRig& rig, const Truth& truth, const TrueTrial& trial, const TrialPlan& plan,
                     const Recording& recording, std::uint64_t seed);

}  // namespace hidden_effects::dirty
