#include "runs/settle.h"

#include "hand_made_case.h"

#include "experiments/benchmark/small_results.h"
#include "support/test_folder.h"

#include <gtest/gtest.h>

namespace hidden_effects {
namespace {

constexpr std::size_t kSamples = 201;      ///< a second: too little to tell the two apart
constexpr double kFrictionTorque = 0.005;  ///< N·m
constexpr std::uint64_t kNoiseSeed = 3;

/// Coulomb's friction against friction that depends on the angle, by the program itself.
TEST(SettleByProgram, FurtherTestsLeaveTheHiddenEffect) {
  MadeCase made = pendulum_case({{"coulomb_friction", 0, {kFrictionTorque}}}, white_noise(), kSamples);
  made.plan.seed = kNoiseSeed;
  make_noisy(made, kNoiseSeed);
  for (std::size_t t = 0; t < made.trials.size(); ++t) made.trials[t].name = "trial_" + std::to_string(t);
  DiagnosisRecord first = small_diagnosis(1, "effect_found", 0.9, {kCoulomb}, {{"position_friction", "joint.hinge"}});
  first.next_test = "triangle motor 0.3 N*m 0.7 Hz 1.5 s";

  const lacuna::TestFolder folder;
  const auto record = settle(made, first, folder.path(), {LACUNA_BINARY_DIRECTORY "/bin/lacuna", 120.0});
  ASSERT_TRUE(record.has_value());
  ASSERT_EQ(record->runs.size(), 3U);
  for (const SettlingRun& run : record->runs) {
    EXPECT_EQ(run.failure, "") << run.choice;
    EXPECT_EQ(run.remaining, run.choice == "none" ? EffectAt() : kCoulomb) << run.choice;
  }
  EXPECT_EQ(record->runs[1].tests.at(0).line, first.next_test);
}

}  // namespace
}  // namespace hidden_effects
