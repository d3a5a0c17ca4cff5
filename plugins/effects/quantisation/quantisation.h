#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// A sensor that reads in steps.
class Quantisation : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
