#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// A sensor whose readings move away evenly in time.
class SensorDrift : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.sensor = SensorStage::drift}; }
  void sense(std::span<double> channels, int which, const StepView& view, const EffectContext& context,
             std::span<double> state) const override;
};

}  // namespace lacuna
