#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Dry friction proportional to the force that the actuators put through the joint, as in a gear.
class LoadFriction : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

}  // namespace lacuna
