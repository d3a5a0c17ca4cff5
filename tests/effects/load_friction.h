#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Test-only: dry friction proportional to what the joint's actuators exert, Fc = ratio·Σ|τ|, as in a loaded gear
/// (P. Hamon, M. Gautier, P. Garrec, IROS 2010).
class LoadFriction : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectHooks hooks() const override { return {.before_step = true}; }
  void before_step(const StepView& view, const EffectContext& context, std::span<double> state,
                   StepLoads& loads) const override;
};

}  // namespace lacuna
