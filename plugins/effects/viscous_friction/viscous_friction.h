#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Friction proportional to a joint's velocity: tau = −b·v, as of a lubricated bearing or a motor's back-EMF.
class ViscousFriction : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
