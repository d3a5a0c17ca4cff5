#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// An actuator that does nothing on small commands.
class DeadZone : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.command = CommandStage::dead_zone}; }
  double command(double value, int which, const StepView& view, const EffectContext& context,
                 std::span<double> state) const override;
};

}  // namespace lacuna
