#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Test-only: a pure delay of a held command, u'(t) = u(t − delay), by the command hook with a memory of its own.
/// What goes on is the mean over the step: a delay of m + f steps gives (1 − f)·u[n−m] + f·u[n−m−1].
/// Before the start the first command counts.
///
/// State per actuator: how many commands it has seen, then a ring of the last ones.
class HeldDelay : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectHooks hooks() const override { return {.command = CommandStage::delay}; }
  int state_size(const EffectContext& context) const override;
  double command(double value, int which, const StepView& view, const EffectContext& context,
                 std::span<double> state) const override;
};

}  // namespace lacuna
