#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// A torque that always pulls a joint the same way: tau = tau0, as of a cable, a spring far from its
/// rest, an amplifier's offset. Positive torque turns the joint in its positive direction.
class JointOffsetTorque : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
