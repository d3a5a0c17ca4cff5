#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Drag of a viscous medium on a body's centre of mass.
class LinearDrag : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

}  // namespace lacuna
