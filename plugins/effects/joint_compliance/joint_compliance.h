#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// An elastic transmission between an actuator's rotor and its joint.
class JointCompliance : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
