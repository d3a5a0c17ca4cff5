#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Dry friction with elastic bristles (LuGre): presliding, break-away, Stribeck curve and rate dependence in one
/// law.
class LugreFriction : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  int state_size(const EffectContext& context) const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
  void advance(const StepView& view, const EffectContext& context, std::span<double> state) const override;
};

}  // namespace lacuna
