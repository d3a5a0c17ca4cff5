#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Friction of the velocity at which two joints move a gear or a belt between them.
class CoupledFriction : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

}  // namespace lacuna
