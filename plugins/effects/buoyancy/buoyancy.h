#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Buoyancy of a body in a medium, at its centre of mass.
class Buoyancy : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

}  // namespace lacuna
