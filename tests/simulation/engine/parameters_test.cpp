#include "simulation/engine/effects.h"
#include "simulation/engine/support.h"

#include <gtest/gtest.h>

namespace lacuna::testing {
namespace {

using Samples = TimeSeries::Samples;

const std::vector<double> kTimes = grid(0.0, 0.5, 0.05);

Samples readings(const ModelStructure& structure, const std::vector<double>& parameters = {}) {
  Rig rig(structure, step_of(0.001));
  rig.run(series("motor", {0.0, 0.2}, {0.4, -0.3}), kTimes, parameters);
  EXPECT_EQ(rig.result.ending, Ending::completed) << rig.result.reason;
  return rig.result.readings.samples;
}

ModelStructure structure_of(RobotSpec robot, std::vector<VariableParameter> parameters = {}) {
  return {.robot = std::move(robot), .effects = {}, .parameters = std::move(parameters)};
}

TEST(Parameters, AParameterActsLikeTheSameNumberInTheRobot) {
  RobotSpec changed = pendulum();
  changed.joints[0].damping = 0.3;
  changed.actuators[0].gain = 1.5;
  changed.gravity.z() = -3.0;
  const ModelStructure variable = structure_of(
      pendulum(),
      {{"joint.hinge.damping", 0.0, 1.0}, {"world.gravity.z", -10.0, 0.0}, {"actuator.motor.gain", 0.0, 2.0}});
  EXPECT_EQ(readings(variable, {0.3, -3.0, 1.5}), readings(structure_of(changed)));
}

TEST(Parameters, MassTakesTheInertiaWithIt) {
  RobotSpec heavy = pendulum();
  heavy.bodies[0].mass *= 2.0;
  for (double* moment : {&heavy.bodies[0].inertia.xx, &heavy.bodies[0].inertia.yy, &heavy.bodies[0].inertia.zz})
    *moment *= 2.0;
  const std::vector<VariableParameter> mass{{"body.rod.mass", 0.5, 3.0}};
  EXPECT_EQ(readings(structure_of(pendulum(), mass), {2.0}), readings(structure_of(heavy)));

  RobotSpec point = pendulum();
  point.bodies[0].inertia_scales_with_mass = false;
  RobotSpec heavy_point = point;
  heavy_point.bodies[0].mass = 2.0;
  EXPECT_EQ(readings(structure_of(point, mass), {2.0}), readings(structure_of(heavy_point)));
}

TEST(Parameters, AnInertiaThatIsAParameterTooHasTheLastWord) {
  RobotSpec expected = pendulum();
  expected.bodies[0].mass = 2.0;
  for (double* moment : {&expected.bodies[0].inertia.xx, &expected.bodies[0].inertia.zz}) *moment *= 2.0;
  expected.bodies[0].inertia.yy = 0.2;
  const ModelStructure variable =
      structure_of(pendulum(), {{"body.rod.inertia.yy", 0.01, 1.0}, {"body.rod.mass", 0.5, 3.0}});
  EXPECT_EQ(readings(variable, {0.2, 2.0}), readings(structure_of(expected)));
}

TEST(Parameters, EffectParametersReachTheirEffect) {
  ExtraMass extra;
  extra.set_overridden({.amend = true, .add_loads = false, .advance = false, .command = false, .sense = false});
  ModelStructure variable = structure_of(pendulum(), {{"effect.more.mass", -1.0, 2.0}});
  variable.effects = {place("more", extra, ElementKind::body, {0}, {0.0})};
  RobotSpec heavy = pendulum();
  heavy.bodies[0].mass += 0.7;
  EXPECT_EQ(readings(variable, {0.7}), readings(structure_of(heavy)));
}

TEST(Parameters, AnAbsentEffectChangesNothing) {
  // ... and one that is at its neutral value agrees to rounding.
  const WearingFriction wear;
  ModelStructure with = structure_of(pendulum());
  const Samples without = readings(with);
  const Misbehaviour idle(Misbehaviour::Kind::writes_nan, 1e9);
  with.effects = {place("idle", idle, ElementKind::world, {})};
  EXPECT_NEAR((readings(with) - without).cwiseAbs().maxCoeff(), 0.0, 1e-12);
}

TEST(Parameters, ValuesDoNotLeakIntoTheNextSimulation) {
  const ModelStructure variable = structure_of(pendulum(), {{"body.rod.mass", 0.5, 3.0}});
  Rig rig(variable, step_of(0.001));
  const lacuna::Test test = constant("motor", 0.2);
  const Samples first = rig.run(test, kTimes, {1.0}).readings.samples;
  rig.run(test, kTimes, {3.0});
  EXPECT_EQ(rig.run(test, kTimes, {1.0}).readings.samples, first);
}

}  // namespace
}  // namespace lacuna::testing
