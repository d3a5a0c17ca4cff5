#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna::simulation {

/// The source of loads on a robot within a step, besides its own joints and actuators.
class LoadSource {
 public:
  virtual ~LoadSource() = default;

  /// Adds to `loads` the loads of a step of this length (s), at the configuration and the velocities of the view. An
  /// engine may ask several times for one step, and take a shorter step instead.
  virtual void add_loads(const StepView& view, double length, StepLoads& loads) = 0;
  /// Called after a step of this length. The view has the configuration for which loads were requested, and the mean
  /// velocities of the step.
  virtual void advance(const StepView& view, double length) = 0;
};

}  // namespace lacuna::simulation
