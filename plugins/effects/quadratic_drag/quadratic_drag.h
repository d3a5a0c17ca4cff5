#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Drag of a turbulent medium on a body's centre of mass.
class QuadraticDrag : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectHooks hooks() const override { return {.before_step = true}; }
  void before_step(const StepView& view, const EffectContext& context, std::span<double> state,
                   StepLoads& loads) const override;
};

}  // namespace lacuna
