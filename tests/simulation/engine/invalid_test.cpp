#include "simulation/engine/effects.h"
#include "simulation/engine/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace lacuna::testing {
namespace {

using ::testing::HasSubstr;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Runs something bad, then something good, in one workspace; the good must be as in a fresh one.
void expect_invalid(const ModelStructure& structure, const lacuna::Test& bad, const std::string& words,
                    const std::vector<double>& bad_parameters = {}, const std::vector<double>& good_parameters = {},
                    const EngineSettings& settings = step_of(0.001)) {
  const lacuna::Test good = constant("motor", 0.1);
  const std::vector<double> early{0.0, 0.01, 0.02}, late{0.0, 0.1, 0.2};
  Rig rig(structure, settings), fresh(structure, settings);
  rig.run(bad, late, bad_parameters);
  ASSERT_EQ(rig.result.ending, Ending::invalid);
  EXPECT_THAT(rig.result.reason, HasSubstr(words));
  EXPECT_TRUE(std::isnan(rig.result.readings.samples(2, 0)));
  rig.run(good, early, good_parameters);
  ASSERT_EQ(rig.result.ending, Ending::completed) << rig.result.reason;
  EXPECT_TRUE(rig.result.reason.empty());
  EXPECT_EQ(rig.result.readings.samples, fresh.run(good, early, good_parameters).readings.samples);
}

ModelStructure with(const PhysicalEffect& effect) {
  return {.robot = pendulum(), .effects = {place("bad", effect, ElementKind::world, {})}, .parameters = {}};
}

TEST(Invalid, NaNCommand) {
  expect_invalid({.robot = pendulum(), .effects = {}, .parameters = {}}, series("motor", {0.0, 0.05}, {0.0, kNaN}),
                 "command of actuator \"motor\" is nan");
}

TEST(Invalid, HugeForceExplodes) {
  expect_invalid({.robot = pendulum(), .effects = {}, .parameters = {}}, series("motor", {0.0, 0.05}, {0.0, 1e12}),
                 "body \"rod\"");
}

TEST(Invalid, ForcesBeyondReason) {
  for (const double force : {1e16, 1e160, 1e308})
    expect_invalid({.robot = pendulum(), .effects = {}, .parameters = {}}, series("motor", {0.0, 0.05}, {0.0, force}),
                   "at 0.05");
}

TEST(Invalid, ThrowingEffectIsNamed) {
  const Misbehaviour effect(Misbehaviour::Kind::throws_error);
  expect_invalid(with(effect), constant("motor", 0.0), "effect.bad: effect \"bad\": the table has no entry here");
}

TEST(Invalid, ForeignExceptionOfAnEffectIsNamed) {
  const Misbehaviour effect(Misbehaviour::Kind::throws_foreign);
  expect_invalid(with(effect), constant("motor", 0.0), "add_loads threw an object of type int");
}

TEST(Invalid, EffectThatWritesNaNIsNamed) {
  const Misbehaviour effect(Misbehaviour::Kind::writes_nan);
  expect_invalid(with(effect), constant("motor", 0.0),
                 "effect.bad: effect \"bad\": it wrote a load that is not finite");
}

TEST(Invalid, EffectWithNegativeDampingIsNamed) {
  const Misbehaviour effect(Misbehaviour::Kind::negative_damping);
  expect_invalid(with(effect), constant("motor", 0.0), "it wrote a load that is not finite or has the wrong sign");
}

TEST(Invalid, EffectThatPushesTooHard) {
  const Misbehaviour effect(Misbehaviour::Kind::pushes_hard);
  expect_invalid(with(effect), constant("motor", 0.0), "at 0.05");
}

TEST(Invalid, ParametersOutOfBounds) {
  const ModelStructure structure{.robot = pendulum(), .effects = {}, .parameters = {{"body.rod.mass", 0.5, 2.0}}};
  for (const double mass : {kNaN, 2.1, -1.0})
    expect_invalid(structure, constant("motor", 0.0), "\"body.rod.mass\"", {mass}, {1.0});
}

TEST(Invalid, MassThatAnEffectMadeNegative) {
  const ExtraMass extra;
  const ModelStructure structure{.robot = pendulum(),
                                 .effects = {place("extra", extra, ElementKind::body, {0}, {0.0})},
                                 .parameters = {{"effect.extra.mass", -5.0, 5.0}}};
  expect_invalid(structure, constant("motor", 0.0), "body \"rod\"", {-3.0}, {1.0});
}

TEST(Invalid, InertiaThatIsNotPositiveDefinite) {
  const ModelStructure structure{
      .robot = pendulum(), .effects = {}, .parameters = {{"body.rod.inertia.xy", -1.0, 1.0}}};
  expect_invalid(structure, constant("motor", 0.0), "not positive definite", {0.9}, {0.01});
}

TEST(Invalid, AControllerThatThrows) {
  class Thrower : public Controller {
    void act(double, std::span<const double>, std::span<double>, std::span<double>) const override {
      throw std::runtime_error("no neurons");
    }
  };
  lacuna::Test test;
  test.drive = std::make_shared<const Thrower>();
  expect_invalid({.robot = pendulum(), .effects = {}, .parameters = {}}, test, "no neurons");
}

TEST(Invalid, FailuresInsideTheEngineLeaveAUsableWorkspace) {
  const Misbehaviour effect(Misbehaviour::Kind::twists_hard);
  ModelStructure structure = with(effect);
  structure.robot.bodies.push_back(structure.robot.bodies[0]);  // two are more than ODE's step for one
  structure.robot.bodies.back().name = "other";
  for (const std::string& engine : engines()) {
    EngineSettings settings = step_of(0.001);
    settings.engine = engine;
    expect_invalid(structure, constant("motor", 0.0), engine == "ode" ? "at 0.05 s: ODE failed" : "the motion exploded",
                   {}, {}, settings);
    Rig rig(structure, settings);
    for (int i = 0; i < 20; ++i) {
      rig.run(constant("motor", 0.0), {0.0, 0.1});
      ASSERT_EQ(rig.result.ending, Ending::invalid);
    }
    rig.run(constant("motor", 0.0), {0.0, 0.02});
    EXPECT_EQ(rig.result.ending, Ending::completed) << rig.result.reason;
  }
}

}  // namespace
}  // namespace lacuna::testing
