#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna::articulated {

/// Who says what acts on a robot within a step, besides its own joints and actuators.
class LoadSource {
 public:
  virtual ~LoadSource() = default;
  /// Adds to `loads` what acts in the middle of a step of this length, at the configuration of the view, where its
  /// velocities are an estimate of the mean over the step. Asked several times for one step.
  virtual void add_loads(const StepView& view, double step, StepLoads& loads) = 0;
  /// A step of this length was taken; the view has the same configuration and the mean velocities.
  virtual void advance(const StepView& view, double step) = 0;
};

}  // namespace lacuna::articulated
