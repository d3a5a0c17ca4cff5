#include "config/experiment_reader.h"
#include "fitting/comparison.h"
#include "fitting/fit.h"
#include "foundation/address.h"
#include "measurement/recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace lacuna {
namespace {

/// The rig of `experiments/real/emps.toml`; its recordings are not part of the project, LACUNA_DATA says where they
/// are.
class Emps : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::getenv("LACUNA_DATA")) GTEST_SKIP() << "LACUNA_DATA is not set";
    experiment_ = read_experiment(LACUNA_SOURCE_DIRECTORY "/experiments/real/emps.toml");
  }

  /// Fits the experiment's model with these effects, by one free run from the model's own start.
  void fit_with(const std::vector<std::string>& effects) {
    experiment_.fit.method = "free_run";
    experiment_.fit.loss = "squared";
    experiment_.fit.starts = 1;
    fit_as_the_file_says(effects);
  }

  void fit_as_the_file_says(const std::vector<std::string>& effects) {
    for (const std::string& effect : effects)
      experiment_.model.effects.push_back({effect, effect, {"joint.slider"}, {}, {}});
    definition_ = define_model(experiment_, PluginCatalog(plugin_search_path({})));
    model_ = compile(definition_.structure, definition_.engine);
    const RobotSpec& robot = definition_.structure.robot;
    trials_ = read_recording(experiment_.target.recording, sensor_channels(robot), command_channels(robot)).trials;
    result_ = fit({definition_, *model_, trials_, experiment_.fit, 1, {2}});
  }

  Comparison comparison() const {
    return compare({definition_, *model_, trials_, experiment_.noise, result_.parameters(), nullptr, {}, 1, {2}});
  }
  double fitted(const std::string& address) const {
    for (const FittedValue& value : result_.values)
      if (value.address == address) return value.value;
    ADD_FAILURE() << "no value " << address;
    return 0.0;
  }

  Experiment experiment_;
  ModelDefinition definition_;
  std::unique_ptr<CompiledModel> model_;
  std::vector<Trial> trials_;
  FitResult result_;
};

// Published: 95.11 kg, 203.5 N·s/m, 20.39 N, −3.165 N on the other side of the equation (Janot, Gautier and Brunot,
// 2019), by inverse dynamics. A free run weighs errors differently, and its minimum is a flat valley 5 to 15 % from
// there.
constexpr double kMass = 95.11, kViscous = 203.5, kCoulomb = 20.39, kOffset = 3.165;
constexpr double kValley = 0.2;
// A simulation fit of the same four values left 2.6 and 5.6 mm, the published ones leave 6.2 and 8.8 mm.
constexpr double kTrainError = 3.5e-3, kTestError = 9e-3;  // m

TEST_F(Emps, FourValuesFollowTheRigToMillimetres) {
  fit_with({"viscous_friction", "coulomb_friction", "joint_offset_torque"});
  EXPECT_NEAR(fitted("body.carriage.mass"), kMass, kValley * kMass);
  EXPECT_NEAR(fitted("effect.viscous_friction.damping"), kViscous, kValley * kViscous);
  EXPECT_NEAR(fitted("effect.coulomb_friction.torque"), kCoulomb, kValley * kCoulomb);
  EXPECT_NEAR(fitted("effect.joint_offset_torque.torque"), kOffset, kValley * kOffset);

  const Comparison errors = comparison();
  ASSERT_EQ(errors.pooled.size(), 2u);
  EXPECT_LT(errors.pooled[0].rmse, kTrainError);
  EXPECT_TRUE(errors.pooled[1].held_out);
  EXPECT_LT(errors.pooled[1].rmse, kTestError);
}

// Without the constant force no viscous and dry friction follow the whole run, though half a second shows them rightly.
// One more value must not make the error larger, and the fit must say that values move.
TEST_F(Emps, WhatShortSegmentsTellDoesNotSpoilTheWholeRun) {
  experiment_.fit.starts = 2;  // for speed; the file leaves four
  fit_as_the_file_says({"viscous_friction"});
  const double viscous_alone = comparison().pooled[0].rmse;
  experiment_.model.effects.clear();
  fit_as_the_file_says({"viscous_friction", "coulomb_friction"});
  EXPECT_LT(comparison().pooled[0].rmse, 1.05 * viscous_alone);
  const std::vector<double>& half_second = result_.stages.at(1).values;
  EXPECT_NEAR(half_second.at(0), kMass, 0.05 * kMass);
  EXPECT_NEAR(half_second.at(1), kCoulomb, 0.05 * kCoulomb);
  EXPECT_NEAR(half_second.at(2), kViscous, 0.05 * kViscous);
  EXPECT_THAT(result_.notes, testing::Contains(testing::StartsWith("effect.coulomb_friction.torque is ")));
}

TEST_F(Emps, WithoutFrictionTheErrorIsTensOfTimesLarger) {
  fit_with({});
  EXPECT_GT(comparison().pooled[0].rmse, 20.0 * kTrainError);
}

}  // namespace
}  // namespace lacuna
