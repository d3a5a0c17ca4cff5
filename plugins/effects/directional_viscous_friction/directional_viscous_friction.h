#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Viscous friction of different size in the two directions of motion.
class DirectionalViscousFriction : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

}  // namespace lacuna
