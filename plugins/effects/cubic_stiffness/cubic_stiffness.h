#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// A spring whose torque grows with the third power of its deflection (Duffing).
class CubicStiffness : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

}  // namespace lacuna
