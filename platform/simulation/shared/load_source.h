#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna::simulation {

/// Who says what acts on a robot within a step, besides its own joints and actuators.
class LoadSource {
 public:
  virtual ~LoadSource() = default;

  /// Adds to `loads` what acts in a step of this length (s), at the configuration and the velocities of the view. An
  /// engine may ask several times for one step, and take a shorter step instead.
  virtual void add_loads(const StepView& view, double length, StepLoads& loads) = 0;
  /// A step of this length was taken. The view has the configuration at which loads were asked for, and the velocities
  /// that led through the step.
  virtual void advance(const StepView& view, double length) = 0;
};

}  // namespace lacuna::simulation
