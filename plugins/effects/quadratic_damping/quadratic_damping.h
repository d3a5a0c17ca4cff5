#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// A torque against a joint's motion that grows with the square of its speed.
class QuadraticDamping : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

}  // namespace lacuna
