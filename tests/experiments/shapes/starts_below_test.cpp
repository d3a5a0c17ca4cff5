#include "eea/small_run.h"
#include "shapes/shape_study.h"
#include "support/small_shape.h"
#include "support/target_genome.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

constexpr std::size_t kFrontRow = 6, kArmRow = 18, kRoll = 3, kTurn = 4;  // of a genome

TEST(StartsBelow, TheTargetStartsNoDeeperThanItself) {
  const auto bench = small_bench({}, kSmallShape);
  const RobotSpec& target = bench->target()->structure.robot;
  Genome genome = five_cylinders_genome();
  EXPECT_FALSE(starts_below(*bench->definition().decode_model(genome).robot, target));
  genome[kFrontRow + kRoll] = 0.5, genome[kFrontRow + kTurn] = 0.5;  // up, and the arm down from its tail
  genome[kArmRow] = 0.4, genome[kArmRow + 1] = 0.0, genome[kArmRow + kRoll] = 0.0, genome[kArmRow + kTurn] = 1.0;
  EXPECT_TRUE(starts_below(*bench->definition().decode_model(genome).robot, target));
}

}  // namespace
}  // namespace lacuna
