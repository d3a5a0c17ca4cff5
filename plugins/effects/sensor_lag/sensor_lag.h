#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// First-order lag of a sensor's readings, as of a filter.
class SensorLag : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.sensor = SensorStage::lag}; }
  int state_size(const EffectContext& context) const override;
  void sense(std::span<double> channels, int which, const StepView& view, const EffectContext& context,
             std::span<double> state) const override;
  double lateness(double time, const EffectContext& context) const override;
};

}  // namespace lacuna
