#include "contacts/hopper_plant.h"

#include "contacts/contact_recording.h"
#include "contacts/reshaped_commands.h"
#include "contacts/write_contact_case.h"
#include "support/test_folder.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace hidden_effects {
namespace {

constexpr double kGravity = 9.81;

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

TEST(HopperPlant, StandsOnItsSpring) {
  constexpr double kTrunk = 4.0, kSpring = 2500.0, kEnd = 4.0, kTolerance = 1e-4;  // m
  const Samples readings = hopper_readings(hopper_truth({}, kTrunk), {0.0}, 1.0, 0.005, static_cast<int>(kEnd / 0.005));
  EXPECT_NEAR(readings[0].back(), -kTrunk * kGravity / kSpring, kTolerance);
  EXPECT_EQ(readings[1].back(), 1.0);
}

TEST(HopperPlant, TouchesWhenItHasFallen) {
  constexpr double kInterval = 0.005;
  const Samples readings = hopper_readings(hopper_truth({}, 4.0), {0.0}, 1.0, kInterval, 60);
  const auto touch = std::find(readings[1].begin(), readings[1].end(), 1.0) - readings[1].begin();
  EXPECT_NEAR(static_cast<double>(touch) * kInterval, std::sqrt(2.0 * kHopperDrop / kGravity), kInterval);
}

/// Each law of the library as the engine has it, at a tenth of the owner's step: another integration of the same.
class HopperLaw : public testing::TestWithParam<std::string> {};

TEST_P(HopperLaw, IsTheEnginesToo) {
  constexpr double kTolerance = 2e-3;  // m; impacts of the two fall into different steps
  constexpr double kSeen = 2.5e-3;     // m, that the law must change
  constexpr double kSize = 3.0;
  ContactRig rig = hopper();
  rig.duration = 0.35;  // up to the first hop
  const lacuna::TestFolder folder;
  write_contact_robot(rig, folder.path());
  const auto law =
      std::find_if(rig.laws.begin(), rig.laws.end(), [](const ContactLaw& one) { return one.name == GetParam(); });
  ASSERT_NE(law, rig.laws.end());
  const SizedContactLaw hidden{*law, law->at_size(kSize)};
  const Samples commands = reshaped_commands(rig, {}, rig.commands(rig.samples(), 5), 1);
  const double interval = rig.interval / kFiner;
  const auto by_itself = [&](const std::vector<SizedContactLaw>& laws) {
    return hopper_readings(hopper_truth(laws, rig.nominal), commands.front(), interval, rig.interval, rig.samples());
  };
  const Samples by_engine =
      EngineModel(rig, folder.path(), Integration::truth, {hidden}).readings(rig.nominal, commands, interval);
  EXPECT_LT(largest_difference(by_itself({hidden})[0], by_engine[0]), kTolerance);
  EXPECT_GT(largest_difference(by_itself({hidden})[0], by_itself({})[0]), kSeen);
}

INSTANTIATE_TEST_SUITE_P(All, HopperLaw,
                         testing::Values("contact_compliance", "viscous_friction", "coulomb_friction",
                                         "cubic_stiffness", "joint_offset_torque", "payload", "actuator_lag",
                                         "command_delay", "torque_gain", "sensor_offset", "sensor_scale",
                                         "sensor_delay", "restitution"),
                         [](const auto& given) { return given.param; });

}  // namespace
}  // namespace hidden_effects
