#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// A hobby servo that lifts a weight on an arm, as it "really" is: the truth behind the recordings in this folder.
/// Nothing of Lacuna reads this file; the recordings and the experiment that fits them know only what the servo's owner
/// would know.
namespace lifting_servo {

/// inertia·q'' + friction·sgn q' + gravity_torque·sin q = torque, q = 0 hanging. Every sample interval the servo reads
/// q and holds the voltage that its gain makes of the error; torque = constant·(voltage − constant·q')/resistance. The
/// gear's teeth rub the harder, the more they carry: friction = load_friction·|torque|, with stiction.
struct Truth {
  double armature = 0.0025;     ///< of rotor and gear, kg·m²
  double arm_mass = 0.08;       ///< kg, with its centre at half of the arm
  double arm_length = 0.12;     ///< m, from the hinge to the weight
  double constant = 0.32;       ///< torque per current, N·m/A
  double resistance = 4.0;      ///< Ohm
  double supply = 12.0;         ///< V
  double duty_limit = 0.9;      ///< largest share of the supply
  double gain = 0.0022;         ///< share of the supply per rad and count of kp
  double kp = 900.0;            ///< counts
  double load_friction = 0.22;  ///< what the model lacks
  double sensor_noise = 3e-4;   ///< standard deviation of white noise on the angle, rad
  int encoder_counts = 4096;    ///< a turn
};

inline constexpr double kSampleInterval = 0.004;  ///< s, of the servo and of the recording
inline constexpr double kDuration = 6.0;          ///< s, of each recording
inline constexpr double kRest = 0.3;              ///< s without a goal at the start of each recording

/// The recordings of this folder: a weight and what it did.
inline constexpr const char* kTrials[] = {"light-waves", "light-steps", "heavy-waves", "heavy-steps"};

/// kg.
double weight_of(const std::string& trial);

/// Goals of one of them, rad, one a sample.
std::vector<double> goals(const std::string& trial);

/// Angles as the encoder says, rad, one a sample. The same `seed` gives the same noise.
std::vector<double> record(const std::vector<double>& goals, double weight, const Truth& truth, std::uint64_t seed);

/// The whole text of a trial's CSV file.
std::string recording_file(const std::string& trial);

}  // namespace lifting_servo
