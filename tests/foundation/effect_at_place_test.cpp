#include "foundation/effect_at_place.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

TEST(EffectAtPlace, IsReadAsItWasWritten) {
  for (const EffectAtPlace& effect :
       {EffectAtPlace{"coulomb_friction", "joint.hinge"}, EffectAtPlace{"slope", "world"}})
    EXPECT_EQ(effect_at_place_from(to_string(effect)), effect);
  EXPECT_EQ(effect_at_place_from("slope"), (EffectAtPlace{"slope", ""}));
}

}  // namespace
}  // namespace lacuna
