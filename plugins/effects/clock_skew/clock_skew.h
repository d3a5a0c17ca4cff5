#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// A sensor whose clock runs faster or slower than that of the commands (D. L. Mills, IEEE Trans. Communications 39
/// (1991) 1482). What the sensor reads at another moment than the present one follows from a parabola through its last
/// three readings: for shifts in time that are short against the motion.
class ClockSkew : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.sensor = SensorStage::delay}; }
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  int state_size(const EffectContext& context) const override;
  void sense(std::span<double> channels, int which, const StepView& view, const EffectContext& context,
             std::span<double> state) const override;
  double lateness(double time, const EffectContext& context) const override;
};

}  // namespace lacuna
