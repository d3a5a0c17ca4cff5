#pragma once

#include "contacts/contact_recording.h"

#include <functional>

namespace hidden_effects {

/// What the owner's model without any effect leaves of trials, by channel; of touch sensors nothing is told (0).
struct ContactLeft {
  double free_value = 0.0;  ///< where it was taken
  std::vector<double> rms;
};

/// With the free value fitted to the trials, to about a hundredth.
ContactLeft left_by_refitted(const ContactRig& rig, const EngineModel& base, const std::vector<ContactTrial>& trials);

/// RMS over the channels of what the base leaves over `floor`: what noise, random forces, the other ground and the
/// owner's step leave of a refitted model that is right.
double strength_of(const ContactLeft& left, const ContactLeft& floor);

/// The law's value at which the refitted base leaves `wanted` times the floor. One that is out of reach is the largest
/// that was tried. `strength_with` tells
/// the strength of a law of some value.
double value_of_strength(const ContactLaw& law, double wanted,
                         const std::function<double(const SizedContactLaw&)>& strength_with);

}  // namespace hidden_effects
