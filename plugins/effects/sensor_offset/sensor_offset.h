#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// A constant that is added to a sensor's readings.
class SensorOffset : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.sensor = SensorStage::offset}; }
  void sense(std::span<double> channels, int which, const StepView& view, const EffectContext& context,
             std::span<double> state) const override;
};

}  // namespace lacuna
