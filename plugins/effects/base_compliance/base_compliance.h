#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// A mount that gives way to the reaction of a joint's actuators.
class BaseCompliance : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  int state_size(const EffectContext& context) const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void before_step(const StepView& view, const EffectContext& context, std::span<double> state,
                   StepLoads& loads) const override;
};

}  // namespace lacuna
