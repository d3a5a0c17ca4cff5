#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Dry friction of a gear in proportion to the actuators' force, of different size where that drives and where it
/// brakes.
class GearEfficiency : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

}  // namespace lacuna
