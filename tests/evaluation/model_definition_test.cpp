#include "evaluation/model/model_definition.h"

#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

#include <limits>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// A cart on a rail that carries a pendulum; a motor and a sensor on the hinge.
RobotSpec cart_pendulum() {
  RobotSpec robot;
  robot.name = "cart_pendulum";
  robot.bodies.resize(2);
  robot.bodies[0].name = "cart";
  robot.bodies[0].mass = 2.0;
  robot.bodies[1].name = "arm";
  robot.bodies[1].mass = 0.5;
  robot.bodies[1].inertia = {.xx = 0.1, .yy = 0.2, .zz = 0.3};
  robot.joints.resize(2);
  robot.joints[0].name = "rail";
  robot.joints[0].kind = JointKind::slider;
  robot.joints[0].child = "cart";
  robot.joints[1].name = "hinge";
  robot.joints[1].parent = "cart";
  robot.joints[1].child = "arm";
  robot.actuators.resize(1);
  robot.actuators[0].name = "motor";
  robot.actuators[0].joint = "hinge";
  robot.sensors.resize(1);
  robot.sensors[0].name = "angle";
  robot.sensors[0].element = "hinge";
  return robot;
}

class DefineModel : public testing::Test {
 protected:
  DefineModel() {
    experiment_.file = "rig.toml";
    experiment_.model.robot = "declared";
    experiment_.model.declared = cart_pendulum();
  }

  EffectEntry& add_effect(const std::string& id, const std::string& effect, std::vector<std::string> where) {
    experiment_.model.effects.push_back({id, effect, std::move(where), {}, {}});
    return experiment_.model.effects.back();
  }
  ModelDefinition define() const { return define_model(experiment_, built_catalog()); }
  /// The problems' sentences, with their places.
  std::vector<std::string> problems() const {
    std::vector<std::string> sentences;
    try {
      define();
    } catch (const BadInput& error) {
      for (const Problem& problem : error.problems())
        sentences.push_back(to_string(problem.location) + ": " + problem.message);
    }
    return sentences;
  }
  static std::vector<std::string> addresses(const ModelDefinition& model) {
    std::vector<std::string> result;
    for (const FreeValue& value : model.free) result.push_back(value.address);
    return result;
  }
  Experiment experiment_;
};

TEST_F(DefineModel, ARobotAloneHasNothingFree) {
  const ModelDefinition model = define();
  EXPECT_EQ(model.structure.robot.bodies.at(1).mass, 0.5);
  EXPECT_THAT(model.free, IsEmpty());
  EXPECT_THAT(model.effects, IsEmpty());
}

TEST_F(DefineModel, SetValuesCountAndAMassTakesItsInertiaAlong) {
  experiment_.model.set = {{"body.arm.mass", 1.5}, {"joint.rail.damping", 7.0}, {"body.arm.inertia.zz", 0.4}};
  const RobotSpec robot = define().structure.robot;
  EXPECT_EQ(robot.bodies[1].mass, 1.5);
  EXPECT_DOUBLE_EQ(robot.bodies[1].inertia.xx, 0.1 * 3.0);
  EXPECT_EQ(robot.bodies[1].inertia.zz, 0.4);
  EXPECT_EQ(robot.joints[0].damping, 7.0);
}

TEST_F(DefineModel, TheCloserPatternWins) {
  experiment_.model.set = {{"body.*.mass", 3.0}, {"body.arm.mass", 1.0}};
  const RobotSpec robot = define().structure.robot;
  EXPECT_EQ(robot.bodies[0].mass, 3.0);
  EXPECT_EQ(robot.bodies[1].mass, 1.0);
}

TEST_F(DefineModel, TwoEquallyClosePatternsAreAProblem) {
  experiment_.model.set = {{"body.a*.mass", 3.0}, {"body.*m.mass", 1.0}};
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("both mean body.arm.mass")));
}

TEST_F(DefineModel, APatternFreesOneValueAnAddressInSpecOrder) {
  experiment_.model.free = {{"joint.*.damping", 0.0, 10.0, std::nullopt}, {"body.*.mass", 0.1, 5.0, std::nullopt}};
  const ModelDefinition model = define();
  EXPECT_THAT(addresses(model),
              ElementsAre("body.cart.mass", "body.arm.mass", "joint.rail.damping", "joint.hinge.damping"));
  EXPECT_THAT(model.start_values(), ElementsAre(2.0, 0.5, 0.0, 0.0));
  EXPECT_EQ(model.free[2].unit, "N*s/m");
  EXPECT_EQ(model.free[3].unit, "N*m*s/rad");
  ASSERT_THAT(model.structure.parameters, SizeIs(4));
  EXPECT_EQ(model.structure.parameters[1].address, "body.arm.mass");
  EXPECT_EQ(model.structure.parameters[1].upper, 5.0);
}

TEST_F(DefineModel, AValueOfTheRobotFileBeyondItsBoundsIsAProblemAtItsPlace) {
  experiment_.model.robot_places = {{"body.cart", {"cart.toml", 3, 1}}, {"body.cart.mass", {"cart.toml", 4, 8}}};
  experiment_.locations = {{"model.free.body.*.mass", {"rig.toml", 20, 16}}};
  experiment_.model.free = {{"body.*.mass", 0.3, 0.8, std::nullopt}};
  EXPECT_THAT(problems(), ElementsAre(AllOf(HasSubstr("cart.toml:4:8: body.cart.mass: 2.00000 kg lies outside"),
                                            HasSubstr("model.free.body.*.mass has at rig.toml:20:16"))));
}

TEST_F(DefineModel, AValueThatTheExperimentSetsBeyondItsBoundsIsAProblemThere) {
  experiment_.locations = {{"model.set.body.arm.mass", {"rig.toml", 17, 4}}};
  experiment_.model.set = {{"body.arm.mass", 0.9}};
  experiment_.model.free = {{"body.arm.mass", 0.3, 0.8, std::nullopt}};
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("rig.toml:17:4: model.set.body.arm.mass: 0.900000 kg lies outside")));
}

TEST_F(DefineModel, AValueAtItsBoundIsWithinWhateverItsUnitWas) {
  experiment_.model.free = {{"body.cart.mass", 2.0 * (1.0 + 1e-15), 5.0, std::nullopt},
                            {"body.arm.mass", 0.1, 0.5, std::nullopt}};
  EXPECT_THAT(define().start_values(), ElementsAre(2.0 * (1.0 + 1e-15), 0.5));
}

TEST_F(DefineModel, AStartOfItsOwnMayDifferFromTheFilesValue) {
  experiment_.model.free = {{"body.cart.mass", 3.0, 5.0, 4.0}};
  EXPECT_THAT(define().start_values(), ElementsAre(4.0));
}

TEST_F(DefineModel, AValueThatNoFileGivesStartsAtTheNearestBoundAndIsNamed) {
  experiment_.model.free = {{"joint.hinge.damping", 0.1, 5.0, std::nullopt}};
  const FreeValue free = define().free.at(0);
  EXPECT_EQ(free.start, 0.1);
  EXPECT_EQ(free.own, 0.0);
}

TEST_F(DefineModel, EffectsAreFreeWithinTheirDeclaredBoundsUnlessFixed) {
  add_effect("rub", "coulomb_friction", {"joint.hinge"}).start = {{"torque", 0.2}};
  add_effect("oil", "viscous_friction", {"joint.rail"}).fixed = {"damping"};
  const ModelDefinition model = define();
  EXPECT_THAT(addresses(model), ElementsAre("effect.rub.torque"));
  EXPECT_EQ(model.free[0].unit, "N*m");
  EXPECT_EQ(model.free[0].start, 0.2);
  EXPECT_EQ(model.free[0].lower, 0.0);
  EXPECT_FALSE(model.free[0].description.empty());
  EXPECT_EQ(model.effects[1].start.at("damping"), 0.0) << "start values are complete";
}

TEST_F(DefineModel, EffectsArePlacedOnTheirElements) {
  add_effect("rub", "coulomb_friction", {"joint.rail"});
  const ModelDefinition model = define();
  ASSERT_THAT(model.structure.effects, SizeIs(1));
  const PlacedEffect& placed = model.structure.effects[0];
  EXPECT_EQ(placed.kind, ElementKind::joint);
  EXPECT_THAT(placed.elements, ElementsAre(0));
  EXPECT_THAT(placed.values, ElementsAre(0.0));
  EXPECT_EQ(placed.file.filename(), "coulomb_friction.so");
  EXPECT_EQ(model.free[0].unit, "N");
}

TEST_F(DefineModel, TheOrderOfTheListAndTheSpellingOfPlacesDoNotMatter) {
  add_effect("b", "viscous_friction", {"joint.h*"});
  add_effect("a", "coulomb_friction", {"joint.hinge"});
  const ModelDefinition one = define();
  experiment_.model.effects.clear();
  add_effect("a", "coulomb_friction", {"joint.h*", "joint.hinge"});
  add_effect("b", "viscous_friction", {"joint.hinge"});
  const ModelDefinition other = define();
  EXPECT_EQ(addresses(one), addresses(other));
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(one.effects[i].id, other.effects[i].id);
    EXPECT_EQ(one.effects[i].where, other.effects[i].where);
  }
}

TEST_F(DefineModel, AllProblemsAreNamedAtOnceAndAtTheirPlaces) {
  experiment_.locations = {
      {"model.set.body.arms.mass", {"rig.toml", 3, 1}},      {"model.effects[0].where[1]", {"rig.toml", 5, 20}},
      {"model.effects[1].effect", {"rig.toml", 6, 7}},       {"model.effects[1].where[0]", {"rig.toml", 6, 30}},
      {"model.effects[2].start.torqe", {"rig.toml", 7, 40}}, {"model.effects[2].fixed[0]", {"rig.toml", 7, 60}}};
  experiment_.model.set = {{"body.arms.mass", 1.0}};
  add_effect("a", "coulomb_friction", {"joint.hinge", "joint.rial"});
  add_effect("b", "coulomb_fricton", {"joint.hing"});
  EffectEntry& typo = add_effect("c", "coulomb_friction", {"joint.hinge"});
  typo.start = {{"torqe", 1.0}};
  typo.fixed = {"size"};
  EXPECT_THAT(problems(),
              ElementsAre(AllOf(HasSubstr("did you mean \"body.arm.mass\"?"), HasSubstr("model.set.body.arms.mass")),
                          HasSubstr("did you mean \"joint.rail\"?"), HasSubstr("did you mean \"coulomb_friction\"?"),
                          HasSubstr("did you mean \"joint.hinge\"?"),
                          HasSubstr("coulomb_friction has no parameter \"torqe\" (did you mean \"torque\"?)"),
                          HasSubstr("no parameter \"size\"; it has torque")));
  EXPECT_THAT(problems()[1], testing::StartsWith("rig.toml:5:20: model.effects[0].where[1]: "));
}

TEST_F(DefineModel, EffectsAreCheckedEvenWhereTheRobotIsMissing) {
  experiment_.model.robot = "quadrupd";
  add_effect("a", "coulomb_fricton", {"joint.hinge"});
  EXPECT_THAT(problems(), testing::UnorderedElementsAre(HasSubstr("did you mean \"quadruped\"?"),
                                                        HasSubstr("did you mean \"coulomb_friction\"?")));
}

TEST_F(DefineModel, ValuesOutsideTheirBoundsAreRefused) {
  experiment_.model.set = {{"body.arm.mass", -1.0}};
  experiment_.model.free = {{"joint.hinge.damping", -1.0, 1.0, std::nullopt}};
  add_effect("a", "coulomb_friction", {"joint.hinge"}).start = {{"torque", -0.5}};
  EXPECT_THAT(problems(), testing::UnorderedElementsAre(HasSubstr("not a possible value of body.arm.mass"),
                                                        HasSubstr("exceeds the possible values of joint.hinge.damping"),
                                                        HasSubstr("outside the range of coulomb_friction")));
}

TEST_F(DefineModel, AnEffectsParameterIsFreeWithinTheRangeThatTheFileGives) {
  EffectEntry& entry = add_effect("a", "coulomb_friction", {"joint.hinge"});
  entry.start = {{"torque", 0.1}};
  entry.range = {{"torque", {0.05, 0.4}}};
  const ModelDefinition definition = define();
  ASSERT_EQ(definition.free.size(), 1U);
  EXPECT_EQ(definition.free[0].lower, 0.05);
  EXPECT_EQ(definition.free[0].upper, 0.4);
}

TEST_F(DefineModel, RangesThatAnEffectCannotHaveAreRefused) {
  add_effect("a", "coulomb_friction", {"joint.hinge"}).range = {{"torque", {-1.0, 1.0}}};
  add_effect("b", "coulomb_friction", {"joint.hinge"}).range = {{"torque", {0.5, 1.0}}};
  add_effect("c", "coulomb_friction", {"joint.hinge"}).range = {{"torqe", {0.5, 1.0}}};
  EXPECT_THAT(problems(), testing::UnorderedElementsAre(HasSubstr("exceeds the range of coulomb_friction"),
                                                        HasSubstr("the start value, 0.00, lies outside"),
                                                        HasSubstr("did you mean \"torque\"?")));
}

TEST_F(DefineModel, PlacesThatAnEffectCannotHaveAreRefused) {
  add_effect("a", "coulomb_friction", {"body.arm"});
  add_effect("b", "coulomb_friction", {});
  add_effect("c", "coulomb_friction", {"joint.rail", "joint.hinge"});
  add_effect("d", "coulomb_friction", {"joint.rail", "body.arm"});
  add_effect("e", "coulomb_friction", {"world"});
  EXPECT_THAT(problems(),
              testing::UnorderedElementsAre(HasSubstr("cannot be placed on a body; place it on a joint"),
                                            HasSubstr("cannot be placed on the world; place it on a joint"),
                                            HasSubstr("is missing: coulomb_friction acts on a joint; say on which one, "
                                                      "as in where = [\"joint.NAME\"]"),
                                            HasSubstr("in N and in N*m at once"), HasSubstr("elements of one kind")));
}

TEST_F(DefineModel, AnEffectsOwnReasonNotToGoThereIsAProblemOfTheFile) {
  experiment_.model.declared->joints[1].kind = JointKind::ball;
  experiment_.model.declared->actuators.clear();
  add_effect("a", "coulomb_friction", {"joint.hinge"});
  EXPECT_THAT(problems(),
              ElementsAre(AllOf(HasSubstr("joint.hinge is a ball joint"), HasSubstr("coulomb_friction.so"))));
}

TEST_F(DefineModel, NumbersWrittenInAnotherDimensionAreRefused) {
  experiment_.model.set = {{"body.arm.mass", 1.0}};
  add_effect("a", "viscous_friction", {"joint.rail"}).start = {{"damping", 1.0}};
  experiment_.written_units = {{"model.set.body.arm.mass", "mm"}, {"model.effects[0].start.damping", "N*m*s/rad"}};
  EXPECT_THAT(problems(), testing::UnorderedElementsAre(HasSubstr("is in mm, but must be in kg"),
                                                        HasSubstr("is in N*m*s/rad, but must be in N*s/m")));
}

TEST_F(DefineModel, RobotParametersAreCheckedAgainstTheirDeclaration) {
  experiment_.model.robot = "quadruped";
  experiment_.model.declared.reset();
  experiment_.model.parameters = {{"torso_mass", 2.5}};
  EXPECT_EQ(define().structure.robot.bodies[0].mass, 2.5);
  experiment_.model.parameters = {{"torso_mas", 2.5}, {"speed_gain", -1.0}};
  EXPECT_THAT(problems(), testing::UnorderedElementsAre(HasSubstr("did you mean \"torso_mass\"?"),
                                                        HasSubstr("outside the range of the robot \"quadruped\"")));
}

TEST_F(DefineModel, ARobotThatCannotBeIsRefusedWithEveryReason) {
  RobotSpec& robot = *experiment_.model.declared;
  robot.joints[1].child = "cart";
  robot.actuators[0].joint = "henge";
  robot.bodies[1].inertia.xy = 5.0;
  robot.joints[0].axis = {0.0, 0.0, 2.0};
  robot.bodies[0].mass = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(problems(), testing::UnorderedElementsAre(
                              HasSubstr("is the child of two joints"), HasSubstr("a cycle of joints"),
                              HasSubstr("\"henge\" is not a joint of the robot (did you mean \"hinge\"?)"),
                              HasSubstr("not positive definite"), HasSubstr("axis is not a unit vector"),
                              HasSubstr("body \"cart\": its mass is nan")));
}

/// What `compile` refuses, a definition must refuse first, with the place in the file.
TEST_F(DefineModel, ElementsOnJointsThatCannotHaveThemAreRefused) {
  RobotSpec& robot = *experiment_.model.declared;
  robot.joints[1].kind = JointKind::fixed;
  EXPECT_THAT(problems(),
              testing::UnorderedElementsAre(AllOf(HasSubstr("actuator \"motor\""), HasSubstr("fixed joint")),
                                            AllOf(HasSubstr("sensor \"angle\""), HasSubstr("fixed joint"))));
}

TEST_F(DefineModel, NamesThatCannotStandInAnAddressAreRefused) {
  experiment_.model.declared->bodies.emplace_back().name = "left.arm";
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("\"left.arm\"; give it a name without dots")));
}

TEST_F(DefineModel, InfiniteLawsAreRefused) {
  experiment_.model.declared->joints[0].damping = kInfinity;
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("joint.rail.damping is inf")));
}

TEST_F(DefineModel, JointsInACircleAreNoRobot) {
  experiment_.model.declared->joints[0].parent = "arm";
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("a cycle of joints"), HasSubstr("a cycle of joints")));
}

}  // namespace
}  // namespace lacuna
