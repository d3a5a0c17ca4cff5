#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// A sensor that cannot read beyond its range.
class SensorSaturation : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.sensor = SensorStage::saturation}; }
  void sense(std::span<double> channels, int which, const StepView& view, const EffectContext& context,
             std::span<double> state) const override;
};

}  // namespace lacuna
