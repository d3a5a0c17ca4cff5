#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Play between a joint and an encoder on the motor's side of its gear.
class EncoderBacklash : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.sensor = SensorStage::geometry}; }
  int state_size(const EffectContext& context) const override;
  void start(const StepView& view, const EffectContext& context, std::span<double> state) const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void sense(std::span<double> channels, int which, const StepView& view, const EffectContext& context,
             std::span<double> state) const override;
};

}  // namespace lacuna
