#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// A motor whose largest torque falls with its speed, because its voltage is limited.
class TorqueSpeedLine : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.command = CommandStage::saturation}; }
  int state_size(const EffectContext& context) const override;
  void start(const StepView& view, const EffectContext& context, std::span<double> state) const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  double command(double value, int which, const StepView& view, const EffectContext& context,
                 std::span<double> state) const override;
};

}  // namespace lacuna
