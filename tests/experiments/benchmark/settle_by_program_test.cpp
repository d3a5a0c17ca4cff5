#include "runs/settle.h"

#include "hand_made_case.h"

#include "experiments/benchmark/small_results.h"
#include "support/test_folder.h"

#include <gtest/gtest.h>

namespace hidden_effects {
namespace {

constexpr std::size_t kSamples = 201;      ///< a second: too little to tell the two apart
constexpr double kFrictionTorque = 0.005;  ///< N·m
constexpr std::uint64_t kDraws = 3;        ///< of the noise
constexpr int kLeastSettled = 2;           ///< of them: the richer law may follow the noise of one as well

/// What further tests leave, as the program chooses them and at random; whether both leave the friction that is there.
bool leaves_the_hidden_effect(std::uint64_t noise_seed) {
  MadeCase made = pendulum_case({{"coulomb_friction", 0, {kFrictionTorque}}}, white_noise(), kSamples);
  made.plan.seed = noise_seed;
  make_noisy(made, noise_seed);
  for (std::size_t t = 0; t < made.trials.size(); ++t) made.trials[t].name = "trial_" + std::to_string(t);
  DiagnosisRecord first = small_diagnosis(1, "effect_found", 0.9, {kCoulomb}, {{"position_friction", "joint.hinge"}});
  first.next_test = "triangle motor 0.3 N*m 0.7 Hz 1.5 s";

  const lacuna::TestFolder folder;
  const auto record = settle(made, first, folder.path(), {LACUNA_BINARY_DIRECTORY "/bin/lacuna", 120.0});
  if (!record || record->runs.size() != 3U) {
    ADD_FAILURE() << "draw " << noise_seed << ": one was told from the other without tests, or nothing was asked";
    return false;
  }
  for (const SettlingRun& run : record->runs) EXPECT_EQ(run.failure, "") << run.choice;
  EXPECT_EQ(record->runs[0].remaining, EffectAt());
  EXPECT_EQ(record->runs[1].tests.at(0).line, first.next_test);
  return record->runs[1].remaining == kCoulomb && record->runs[2].remaining == kCoulomb;
}

/// Coulomb's friction against friction that depends on the angle, by the program itself.
TEST(SettleByProgram, FurtherTestsLeaveTheHiddenEffect) {
  int settled = 0;
  for (std::uint64_t draw = 1; draw <= kDraws; ++draw) settled += leaves_the_hidden_effect(draw) ? 1 : 0;
  EXPECT_GE(settled, kLeastSettled);
}

}  // namespace
}  // namespace hidden_effects
