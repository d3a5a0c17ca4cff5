#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Coulomb friction between bodies and ground.
class ContactFriction : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
