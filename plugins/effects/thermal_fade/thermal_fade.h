#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// An actuator that gets weaker as it gets warm.
class ThermalFade : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.command = CommandStage::gain}; }
  void start(const StepView& view, const EffectContext& context, std::span<double> state) const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  int state_size(const EffectContext& context) const override;
  double command(double value, int which, const StepView& view, const EffectContext& context,
                 std::span<double> state) const override;
};

}  // namespace lacuna
