#pragma once

#include <lacuna/plugin.h>

namespace bad {

/// An effect without parameters that may stand on joints, actuators, sensors and in the world.
class Effect : public lacuna::PhysicalEffect {
 public:
  lacuna::EffectDescription describe() const override {
    lacuna::EffectDescription description;
    description.summary = "Broken on purpose";
    description.placements = {lacuna::ElementKind::joint, lacuna::ElementKind::actuator, lacuna::ElementKind::sensor,
                              lacuna::ElementKind::world};
    return description;
  }
};

/// From here on the mid-run ones misbehave, s.
inline constexpr double kOnset = 0.05;

}  // namespace bad
