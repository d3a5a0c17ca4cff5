#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Test-only: a point mass carried by a body, at a place of its frame. It amends mass, centre of mass and inertia
/// (Steiner's theorem for both parts about the new centre).
class Payload : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectHooks hooks() const override { return {.amends_robot = true}; }
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
