#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Buoyancy of a body in a medium, at its centre of mass.
class Buoyancy : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void before_step(const StepView& view, const EffectContext& context, std::span<double> state,
                   StepLoads& loads) const override;
};

}  // namespace lacuna
