#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// A limit to the force that an actuator exerts.
class TorqueSaturation : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
