#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// An encoder disc that is not centred: an error that repeats with the reading.
class EncoderEccentricity : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.sensor = SensorStage::geometry}; }
  void sense(std::span<double> channels, int which, const StepView& view, const EffectContext& context,
             std::span<double> state) const override;
};

}  // namespace lacuna
