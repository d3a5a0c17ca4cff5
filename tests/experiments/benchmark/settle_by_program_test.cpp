#include "runs/settle.h"

#include "hand_made_case.h"

#include "experiments/benchmark/small_results.h"
#include "support/test_folder.h"

#include <gtest/gtest.h>

namespace hidden_effects {
namespace {

constexpr std::size_t kSamples = 101;      ///< half a second: mostly too little to tell the two apart
constexpr double kFrictionTorque = 0.005;  ///< N·m
constexpr std::uint64_t kDraws = 3;        ///< of the noise
constexpr int kLeastSettled = 2;           ///< of them: the richer law may follow the noise of one as well

/// What further tests leave of one draw of the noise.
struct Settled {
  bool asked = false;  ///< the data alone did not tell the two apart
  bool right = false;  ///< all that was asked left the friction that is there
};

/// By tests as the program chooses them and at random.
Settled settled(std::uint64_t noise_seed) {
  MadeCase made = pendulum_case({{"coulomb_friction", 0, {kFrictionTorque}}}, white_noise(), kSamples);
  made.plan.seed = noise_seed;
  make_noisy(made, noise_seed);
  for (std::size_t t = 0; t < made.trials.size(); ++t) made.trials[t].name = "trial_" + std::to_string(t);
  DiagnosisRecord first = small_diagnosis(1, "effect_found", 0.9, {kCoulomb}, {{"position_friction", "joint.hinge"}});
  first.next_test = "triangle motor 0.3 N*m 0.7 Hz 1.5 s";

  const lacuna::TestFolder folder;
  const auto record = settle(made, first, folder.path(), {LACUNA_BINARY_DIRECTORY "/bin/lacuna", 120.0});
  if (!record) {
    ADD_FAILURE() << "draw " << noise_seed << ": nothing was asked";
    return {};
  }
  for (const SettlingRun& run : record->runs) EXPECT_EQ(run.failure, "") << run.choice;
  if (record->runs.size() == 1U) return {false, record->runs[0].remaining == kCoulomb};
  EXPECT_EQ(record->runs.size(), 3U);
  EXPECT_EQ(record->runs[0].remaining, EffectAt());
  EXPECT_EQ(record->runs[1].tests.at(0).line, first.next_test);
  return {true, record->runs[1].remaining == kCoulomb && record->runs[2].remaining == kCoulomb};
}

/// Coulomb's friction against friction that depends on the angle, by the program itself.
TEST(SettleByProgram, FurtherTestsLeaveTheHiddenEffect) {
  int asked = 0, right = 0;
  for (std::uint64_t draw = 1; draw <= kDraws; ++draw) {
    const Settled one = settled(draw);
    asked += one.asked ? 1 : 0;
    right += one.right ? 1 : 0;
  }
  EXPECT_GE(asked, kLeastSettled);
  EXPECT_GE(right, kLeastSettled);
}

}  // namespace
}  // namespace hidden_effects
