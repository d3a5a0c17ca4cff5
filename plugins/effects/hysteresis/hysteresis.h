#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Elastic force with a memory of the direction of motion (Bouc–Wen with exponent 1).
class Hysteresis : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  int state_size(const EffectContext& context) const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
  void advance(const StepView& view, const EffectContext& context, std::span<double> state) const override;
};

}  // namespace lacuna
