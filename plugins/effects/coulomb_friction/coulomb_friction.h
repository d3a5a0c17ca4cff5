#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Dry friction of constant size in a joint: tau = −Fc·sgn v, and whatever holds the joint still
/// up to Fc (C. A. Coulomb, Théorie des machines simples, 1785).
class CoulombFriction : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
