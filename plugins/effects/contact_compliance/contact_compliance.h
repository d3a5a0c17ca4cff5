#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Elastic ground contact whose damping grows with the penetration (Hunt and Crossley).
class ContactCompliance : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
