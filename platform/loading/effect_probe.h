#pragma once

#include <lacuna/physical_effect.h>

#include <string>

namespace lacuna {

/// Findings from calls of an effect's hooks.
struct EffectFindings {
  std::string problem;  ///< why it cannot be used; empty: it can
  std::string remark;   ///< a fault that does not change results; empty: none
};

/// Calls the hooks of an effect on a robot of two links, at each kind of element on which it can be placed, and checks
/// the rules of lacuna/physical_effect.h: it must not read beyond its parameters nor write beyond its state, must add
/// to the loads of others, and must not allocate in a step. An exception is not a finding: the effect may refuse this
/// robot. Only in a process that tries plugins; throws `ProcessChanged`.
EffectFindings try_effect(const PhysicalEffect& effect, const EffectDescription& description);

}  // namespace lacuna
