#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Resistance of the ground to rolling and turning.
class RollingResistance : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
