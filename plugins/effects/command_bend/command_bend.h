#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// A drive whose force is not in proportion to its command: it grows with the square, or ever less.
class CommandBend : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  EffectStages stages() const override { return {.command = CommandStage::saturation}; }
  double command(double value, int which, const StepView& view, const EffectContext& context,
                 std::span<double> state) const override;
};

}  // namespace lacuna
