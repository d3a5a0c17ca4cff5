#pragma once

#include "cases/make_case.h"

namespace hidden_effects {

/// How large things are at a place in trials that a plant made. `element` counts joints, bodies, drives or sensors; of
/// `kEverywhere` the first one stands for all.
Scales scales_of(const PlantSpec& spec, Place place, int element, const std::vector<Excitation>& excitations,
                 const std::vector<Motion>& motions);

/// The joint that a place belongs to; 0 for the world.
int joint_of(const PlantSpec& spec, Place place, int element);

}  // namespace hidden_effects
