#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Contacts that creep in proportion to the tangential force, as tyres do.
class WheelSlip : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
