#include "contacts/reshaped_commands.h"

#include <gmock/gmock.h>

#include <numeric>

namespace hidden_effects {
namespace {

constexpr double kSize = 0.03;       // s, of the laws
constexpr double kTolerance = 3e-3;  // s, of a mean delay

/// By how much a rise from 0 to 1 in the middle of a trial is late on average: the area between told and applied.
double lateness(const std::string& law) {
  const ContactRig rig = hopper();
  const auto samples = static_cast<std::size_t>(rig.samples());
  std::vector<double> rise(samples, 0.0);
  std::fill(rise.begin() + static_cast<std::ptrdiff_t>(samples / 2), rise.end(), 1.0);
  const Samples applied = reshaped_commands(rig, {{contact_law(rig, law, "actuator.motor"), kSize}}, {rise}, 1);
  const double told = kFiner * std::accumulate(rise.begin(), rise.end(), 0.0);
  const double got = std::accumulate(applied.front().begin(), applied.front().end(), 0.0);
  return (told - got) * rig.interval / kFiner;
}

TEST(ReshapedCommands, ComeLaterByTheMeanDelay) {
  EXPECT_NEAR(lateness("jittered_delay"), kSize, 0.5 * kSize);
  EXPECT_NEAR(lateness("two_stage_lag"), kSize, kTolerance);
}

TEST(ReshapedCommands, AreHeldWhereNoLawConcernsThem) {
  const ContactRig rig = hopper();
  const Samples applied = reshaped_commands(rig, {{contact_law(rig, "restitution", ""), 0.4}}, {{1.0, 2.0}}, 1);
  ASSERT_EQ(applied.front().size(), 2U * kFiner);
  EXPECT_EQ(applied.front()[kFiner - 1], 1.0);
  EXPECT_EQ(applied.front()[kFiner], 2.0);
}

}  // namespace
}  // namespace hidden_effects
