#pragma once

#include "plant/simulation.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hidden_effects {

/// A value of the model that its user frees, and how the plant has it.
struct FreeValue {
  std::string address;              ///< in the robot file, as "body.arm.mass"
  double spread = 0.15;             ///< by how large a share the true value may differ from the nominal one
  double lower = 0.3, upper = 3.0;  ///< bounds of the fit, times the nominal value
  double& (*of)(PlantSpec&) = nullptr;
};

/// How strongly a rig is excited and read. SI.
struct RigScales {
  std::vector<double> amplitude;        ///< RMS of the commands, by drive
  double slowest = 0.2, fastest = 3.0;  ///< Hz, of the commands
  std::vector<double> sensor_noise;     ///< standard deviation, by sensor
  std::vector<double> quantum;          ///< of a coarse encoder, by sensor
  double random_force = 0.02;           ///< RMS over the RMS of a drive's command or force
  double command_noise = 0.01;          ///< RMS over the RMS of the command
};

/// A bench as its owner would write it down.
struct Rig {
  std::string name;
  PlantSpec nominal;
  std::vector<FreeValue> free;
  RigScales scales;
  double interval = 0.005;  ///< s, between samples
};

Rig servo_pendulum();
Rig spring_slider();
Rig position_servo();
Rig cart_pole();
Rig two_link_arm();

const std::vector<Rig>& planar_rigs();

/// The one of that name; throws `std::invalid_argument`.
const Rig& rig_named(const std::string& name);

/// The commands of a trial of `duration` s, one a sample for each drive, starting with 0.2 s of nothing: `kind` 0
/// multisine, 1 steps, 2 chirp, 3 slow triangle with a multisine on it.
std::vector<std::vector<double>> commands(const Rig& rig, int kind, double duration, std::uint64_t seed);

}  // namespace hidden_effects
