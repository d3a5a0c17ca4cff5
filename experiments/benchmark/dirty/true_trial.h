#pragma once

#include "dirty/dirty_rig.h"
#include "plant/simulation.h"

#include <cstdint>
#include <vector>

namespace hidden_effects::dirty {

/// What really happens: the rig's true values and the laws that it obeys.
struct Truth {
  PlantSpec spec;
  Laws laws;
  int finer = 1;  ///< integration steps over those of the rig
};

/// A trial as it was, without any noise.
struct TrueTrial {
  Excitation applied;              ///< what the drives were told; of an imposed motion nothing
  std::vector<PlantState> states;  ///< at each sample; of an imposed motion none
  Motion motion;                   ///< at each integration step; of an imposed motion at each sample
  std::vector<double> force;       ///< of an imposed motion: what it takes at each sample, N·m or N
};

/// Integration steps of a sample interval.
int steps_a_sample(const DirtyRig& rig, int finer);

/// Random forces of a trial; none: it is not disturbed.
struct Disturbance {
  std::vector<double> forces = {};  ///< standard deviation by joint, N·m or N
  double memory = 0.0;              ///< s, in which they forget
};

/// Carries a trial out. A controller outside reads positions or velocities with noise of the standard deviations
/// `reading_noise` (by sensor), which follows from `seed`. Throws `std::runtime_error` where the plant runs away.
TrueTrial carry_out(const DirtyRig& rig, const Truth& truth, const TrialPlan& trial,
                    const std::vector<double>& reading_noise, std::uint64_t seed, const Disturbance& disturbance = {});

/// What a motion of joint 0 takes, N·m or N at each sample: inertia, springs, friction and all laws.
std::vector<double> force_needed(const PlantSpec& spec, const Laws& laws, const std::vector<double>& positions,
                                 double interval);

/// What a sensor makes of a trial, evenly spaced from its start.
DenseReadings read_densely(const PlantSpec& spec, const Laws& laws, const TrueTrial& trial, std::size_t sensor);

/// How many of these lie in a sample interval.
std::size_t readings_a_sample(const TrueTrial& trial);

}  // namespace hidden_effects::dirty
