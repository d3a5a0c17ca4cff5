#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Play between an actuator's rotor and its joint.
class Backlash : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
