#pragma once

#include <lacuna/physical_effect.h>

#include <string>

namespace lacuna {

/// What became plain of an effect when its hooks were called.
struct EffectFindings {
  std::string problem;  ///< why it cannot be used; empty: nothing speaks against it
  std::string remark;   ///< what it does that it should not, but does no harm to results; empty: nothing
};

/// Calls the hooks of an effect on a robot of two links, at each kind of element that it may stand on, and tells
/// whether it keeps to what lacuna/physical_effect.h asks for: that it reads no further than its parameters, writes no
/// further than its state, adds to the loads of others, and allocates nothing in a step. What it throws is no finding:
/// it may have reasons of its own not to go on this robot. Only in a process that tries plugins; throws
/// `ProcessChanged`.
EffectFindings try_effect(const PhysicalEffect& effect, const EffectDescription& description);

}  // namespace lacuna
