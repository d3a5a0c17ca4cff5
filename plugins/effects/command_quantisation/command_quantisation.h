#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// A drive that takes its command in whole steps.
class CommandQuantisation : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.command = CommandStage::quantisation}; }
  double command(double value, int which, const StepView& view, const EffectContext& context,
                 std::span<double> state) const override;
};

}  // namespace lacuna
