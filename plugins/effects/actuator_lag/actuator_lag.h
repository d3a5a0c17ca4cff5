#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// First-order lag of an actuator's command, as of a current loop or a valve.
class ActuatorLag : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.command = CommandStage::lag}; }
  int state_size(const EffectContext& context) const override;
  double command(double value, int which, const StepView& view, const EffectContext& context,
                 std::span<double> state) const override;
};

}  // namespace lacuna
