#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// A linear spring in a joint: tau = −k·(q − rest).
class JointSpring : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
