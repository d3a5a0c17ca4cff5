#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Test-only: gives a body a push in the first step, so that it flies on with a known momentum. Parameters:
/// impulse x, y, z (N·s) through the centre of mass and angular impulse x, y, z (N·m·s), world frame.
class Kick : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

}  // namespace lacuna
