#pragma once

#include "contacts/contact_rig.h"

namespace hidden_effects {

inline constexpr int kFiner = 10;  ///< applied commands are told so often between two samples

/// Commands as the drives get them, `kFiner` values a sample: held, and changed by those laws that the library has in
/// another form, "jittered_delay" (a delay of half to one and a half of its size, another one every sample) and
/// "two_stage_lag" (two lags of half the time one after the other). Other laws change nothing here.
Samples reshaped_commands(const ContactRig& rig, const std::vector<SizedContactLaw>& laws, const Samples& commands,
                          std::uint64_t seed);

}  // namespace hidden_effects
