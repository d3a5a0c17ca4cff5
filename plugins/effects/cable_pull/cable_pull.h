#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// A constant pull on a body's centre of mass towards a fixed point.
class CablePull : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

}  // namespace lacuna
