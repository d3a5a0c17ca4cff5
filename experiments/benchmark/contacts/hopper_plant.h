#pragma once

#include "contacts/contact_rig.h"

#include <limits>

namespace hidden_effects {

/// A hopper on a vertical rail, integrated here and not by the engine: a trunk, a foot on a springy leg with a linear
/// motor, and the ground, from which the foot leaves with a share of its speed. The leg's length and the foot's touch
/// are measured; how high the trunk is, nobody knows after the start. Zero, unless said otherwise: not there. SI.
struct HopperTruth {
  double trunk = 4.0;                ///< kg
  double restitution = 0.0;          ///< of foot and ground
  double falling_restitution = 0.0;  ///< that of slow impacts; fast ones give back less
  double ground_stiffness = std::numeric_limits<double>::infinity();  ///< N/m; Hunt and Crossley's law
  double hertz_stiffness = std::numeric_limits<double>::infinity();   ///< N/m^1.5; the same with Hertz's exponent
  double viscous = 0.0;                                               ///< of the leg, beside the owner's
  double viscous_power = 0.0;                                         ///< of the leg: coefficient of v^0.8
  double dry = 0.0;                                                   ///< of the leg
  double smooth_dry = 0.0;                                            ///< of the leg: rises over 0.1 m/s
  double cubic_stiffness = 0.0;
  double leg_force = 0.0;
  double foot_load = 0.0;                                              ///< kg
  double lag = 0.0, delay = 0.0, gain = 1.0;                           ///< of the motor
  double length_offset = 0.0, length_scale = 1.0, length_delay = 0.0;  ///< of the sensor
};

inline constexpr double kHopperDrop = 0.15;  ///< m, of trunk and foot at the start

/// The hopper with these laws. Laws of commands alone (`reshaped_commands`) are passed over.
HopperTruth hopper_truth(const std::vector<SizedContactLaw>& laws, double trunk);

/// Length of the leg and touch (+1, −1), `samples` of them `interval` s apart. `motor`: what the motor is told, evenly
/// spaced by `command_interval` s and held.
Samples hopper_readings(const HopperTruth& truth, const std::vector<double>& motor, double command_interval,
                        double interval, int samples);

}  // namespace hidden_effects
