#include "diagnosis/rounds/selection.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

constexpr double kOwnRange = 3.0;

/// An effect `x` with two parameters within 0 and 3, fitted to 1 with these standard deviations.
FoundEffect fitted_with(double first, double second) {
  ModelDefinition definition;
  Refit fit;
  fit.covariance = Eigen::Vector2d(first * first, second * second).asDiagonal();
  for (const char* name : {"a", "b"}) {
    FreeValue& value = definition.free.emplace_back();
    value.address = std::string("effect.x.") + name;
    value.upper = kOwnRange;
    fit.values.push_back(1.0);
    fit.at_bound.push_back(false);
  }
  EffectEntry entry;
  entry.id = "x";
  return found_effects({entry}, definition, fit).front();
}

TEST(FoundEffects, ValuesHaveIntervalsOfTheirDeviations) {
  const FoundEffect effect = fitted_with(0.1, 0.6);
  EXPECT_NEAR(effect.parameters[0].lower_95, 0.804, 1e-3);
  EXPECT_NEAR(effect.parameters[0].upper_95, 1.196, 1e-3);
  EXPECT_EQ(effect.parameters[1].lower_95, 0.0) << "no interval goes beyond the bounds";
}

/// A value that is uniform within 0 and 3 has the deviation 3/√12: data that leave it as it was tell nothing of it.
TEST(FoundEffects, WhatTheDataDoNotTellHasNoInterval) {
  const FoundEffect effect = fitted_with(0.1, 0.99 * kOwnRange / std::sqrt(12.0));
  EXPECT_TRUE(std::isfinite(effect.parameters[0].lower_95));
  EXPECT_TRUE(std::isnan(effect.parameters[1].lower_95));
  EXPECT_TRUE(std::isnan(effect.parameters[1].upper_95));
}

}  // namespace
}  // namespace lacuna
