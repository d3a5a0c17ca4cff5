#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// A torque that varies periodically with the position, as of a motor's magnets or an unbalanced wheel.
class Cogging : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

}  // namespace lacuna
