#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Test-only: an elastic transmission between rotor and joint (M. W. Spong, J. Dynamic Systems, Measurement and
/// Control 109 (1987) 310). It amends the actuators' transmissions; the engine then keeps the rotor's motion.
class JointCompliance : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectHooks hooks() const override { return {.amends_robot = true}; }
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
