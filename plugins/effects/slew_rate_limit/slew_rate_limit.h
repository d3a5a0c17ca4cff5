#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// A limit to how quickly an actuator's command is followed.
class SlewRateLimit : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.command = CommandStage::slew_rate}; }
  int state_size(const EffectContext& context) const override;
  double command(double value, int which, const StepView& view, const EffectContext& context,
                 std::span<double> state) const override;
};

}  // namespace lacuna
