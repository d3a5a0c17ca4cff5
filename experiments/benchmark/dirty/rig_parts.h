#pragma once

#include "dirty/dirty_rig.h"

namespace hidden_effects::dirty {

inline constexpr double kGravity = 9.81;  ///< m/s²
inline constexpr std::size_t kMostSamples = 20000, kFewestSamples = 25;
inline constexpr double kSlowest = 15.0, kFastest = 2000.0;  ///< Hz, of recordings
inline constexpr double kLongest = 120.0;                    ///< s, of a recording

/// A length that goes with a mass, as of things of one density and many shapes: m.
double length_for(double mass, RigDraw& draw);

/// How long recordings are and how often they are sampled: `periods` of the rig's rate and `samples_a_period`, each
/// drawn from its range, within the limits above.
struct Sampling {
  double interval = 0.01;  ///< s
  std::size_t samples = 0;
};
Sampling sampling(double rate, double least_periods, double most_periods, double least_samples, double most_samples,
                  RigDraw& draw);

/// One to three files; the last is held out where there is more than one.
std::vector<TrialPlan> empty_trials(std::size_t samples, std::size_t joints, RigDraw& draw);

/// A reference signal of unit size, one value a sample: multisine, steps, triangle, chirp or single sine, of rates up
/// to `fastest` rad/s, beginning with a tenth of the slowest period of nothing.
enum class Wave { multisine, steps, triangle, chirp, sine };
std::vector<double> wave(Wave kind, std::size_t samples, double interval, double slowest, double fastest,
                         RigDraw& draw);
Wave any_wave(RigDraw& draw);

/// A hinge with a body whose centre of mass is `lever` m above it (below where negative) and that has `share` of the
/// point mass's inertia about its own.
PlantBody hanging(const std::string& name, double mass, double lever, double share);

/// Makes a value one that the owner fits, with the chance `share`, or else one that the robot file states.
void fit_or_state(DirtyRig& rig, RobotValue value, double share, RigDraw& draw);

/// Inertia of the chain at a joint with all joints at zero, rotors and armatures included: kg·m² or kg.
double inertia_at(const PlantSpec& spec, int joint);

/// N·m/rad: how fast gravity's torque at a hinge falls with its angle around zero; negative where the rig is upright.
double gravity_stiffness(const PlantSpec& spec, int joint);

/// Gives a joint viscous friction of a damping ratio at the rig's rate, which the owner fits or states; `maybe_damp` in
/// half of the cases.
void damp(DirtyRig& rig, int joint, double ratio, RigDraw& draw);
void maybe_damp(DirtyRig& rig, int joint, double ratio, RigDraw& draw);

}  // namespace hidden_effects::dirty
