#include "simulation/engine/support.h"

#include <gtest/gtest.h>

namespace lacuna::testing {
namespace {

using Samples = TimeSeries::Samples;

const std::vector<double> kSetupTimes = grid(0.0, 0.5, 0.05);

/// A pendulum whose rod weighs 2 kg in the setup "heavy", and has a damping of its own in "oiled".
ModelStructure pendulum_with_setups() {
  ModelStructure structure{.robot = pendulum(), .effects = {}, .parameters = {}};
  structure.setups = {{"heavy", {{"body.rod.mass", 2.0}}}, {"oiled", {}}};
  structure.parameters = {
      {"body.rod.mass", 0.5, 3.0}, {"joint.hinge.damping", 0.0, 1.0}, {"joint.hinge.damping", 0.0, 1.0, "oiled"}};
  return structure;
}

Samples setup_readings(const ModelStructure& structure, const std::vector<double>& parameters,
                       const std::string& setup) {
  Rig rig(structure, step_of(0.001));
  lacuna::Test test = series("motor", {0.0, 0.2}, {0.4, -0.3});
  test.setup = setup;
  rig.run(test, kSetupTimes, parameters);
  EXPECT_EQ(rig.result.ending, Ending::completed) << rig.result.reason;
  return rig.result.readings.samples;
}

/// The same numbers without any setup.
Samples plain(double mass, double damping) {
  ModelStructure structure = pendulum_with_setups();
  structure.setups.clear();
  structure.parameters.pop_back();
  return setup_readings(structure, {mass, damping}, {});
}

TEST(Setups, ATestWithoutOneHasTheValuesOfAll) {
  EXPECT_EQ(setup_readings(pendulum_with_setups(), {1.2, 0.3, 0.9}, {}), plain(1.2, 0.3));
}

TEST(Setups, WhatASetupSetsTakesTheInertiaWithIt) {
  EXPECT_EQ(setup_readings(pendulum_with_setups(), {1.2, 0.3, 0.9}, "heavy"), plain(2.0, 0.3));
}

TEST(Setups, AParameterOfASetupCountsInItAlone) {
  EXPECT_EQ(setup_readings(pendulum_with_setups(), {1.2, 0.3, 0.9}, "oiled"), plain(1.2, 0.9));
}

TEST(Setups, AWorkspaceGoesFromOneToAnother) {
  const ModelStructure structure = pendulum_with_setups();
  Rig rig(structure, step_of(0.001));
  lacuna::Test test = series("motor", {0.0, 0.2}, {0.4, -0.3});
  test.setup = "heavy";
  rig.run(test, kSetupTimes, {1.2, 0.3, 0.9});
  test.setup.clear();
  rig.run(test, kSetupTimes, {1.2, 0.3, 0.9});
  EXPECT_EQ(rig.result.readings.samples, plain(1.2, 0.3));
}

TEST(Setups, OneThatTheModelDoesNotHaveIsAnError) {
  EXPECT_THROW(setup_readings(pendulum_with_setups(), {1.2, 0.3, 0.9}, "light"), Error);
}

TEST(Setups, ImpossibleOnesAreRefused) {
  const auto compiles = [](const ModelStructure& structure) { compile(structure, step_of(0.001)); };
  ModelStructure negative = pendulum_with_setups();
  negative.setups[0].values[0].value = -1.0;
  EXPECT_THROW(compiles(negative), BadInput);
  ModelStructure unknown = pendulum_with_setups();
  unknown.setups[0].values[0].address = "body.stick.mass";
  EXPECT_THROW(compiles(unknown), BadInput);
  ModelStructure of_none = pendulum_with_setups();
  of_none.parameters[2].setup = "light";
  EXPECT_THROW(compiles(of_none), BadInput);
}

/// A delay that only a setup has needs its memory too.
TEST(Setups, ADelayMayBeThatOfASetup) {
  ModelStructure structure{.robot = pendulum(), .effects = {}, .parameters = {}};
  structure.setups = {{"late", {{"actuator.motor.delay", 0.1}}}};
  RobotSpec late = pendulum();
  late.actuators[0].delay = 0.1;
  EXPECT_EQ(setup_readings(structure, {}, "late"),
            setup_readings({.robot = late, .effects = {}, .parameters = {}}, {}, {}));
}

}  // namespace
}  // namespace lacuna::testing
