#include "evaluation/model/redundant_effect.h"

#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

/// Two arms, one behind the other.
class RedundantEffect : public testing::Test {
 protected:
  RedundantEffect() {
    experiment_.file = "rig.toml";
    experiment_.model.robot = "declared";
    RobotSpec& robot = experiment_.model.declared.emplace();
    robot.name = "arms";
    for (const std::string name : {"upper", "lower"}) {
      BodySpec body;
      body.name = name;
      body.mass = 0.5;
      body.com = {0.0, 0.0, -0.3};
      body.inertia = {.xx = 0.1, .yy = 0.2, .zz = 0.3};
      robot.bodies.push_back(body);
      JointSpec joint;
      joint.name = name;
      joint.child = name;
      if (name == "lower") joint.parent = "upper";
      robot.joints.push_back(joint);
    }
  }
  std::string add(const std::vector<std::string>& free, EffectEntry entry) {
    for (const std::string& address : free) experiment_.model.free.push_back({address, 0.01, 5.0, std::nullopt});
    entry.id = "it";
    experiment_.model.effects = {std::move(entry)};
    return redundancy_of(define_model(experiment_, built_catalog()), "it");
  }
  Experiment experiment_;
};

TEST_F(RedundantEffect, IsFrictionBesideAFreeDamping) {
  EXPECT_THAT(add({"joint.*.damping"}, {"", "viscous_friction", {"joint.lower"}, {}, {}}),
              AllOf(HasSubstr("viscous_friction has the same influence as joint.lower.damping"),
                    HasSubstr("data determine only both together")));
}

TEST_F(RedundantEffect, IsARotorBesideAFreeOne) {
  EXPECT_THAT(add({"joint.*.armature"}, {"", "armature", {"joint.*"}, {}, {}}),
              HasSubstr("joint.upper.armature, joint.lower.armature"));
}

TEST_F(RedundantEffect, IsNotOneThatReachesAJointWhoseDampingIsHeld) {
  EXPECT_THAT(add({"joint.lower.damping"}, {"", "viscous_friction", {"joint.*"}, {}, {}}), IsEmpty());
}

TEST_F(RedundantEffect, IsNotOneThatDoesSomethingElse) {
  EXPECT_THAT(add({"joint.*.damping"}, {"", "coulomb_friction", {"joint.lower"}, {}, {}}), IsEmpty());
  EXPECT_THAT(add({}, {"", "linear_drag", {"body.lower"}, {}, {}}), IsEmpty());
}

TEST_F(RedundantEffect, IsNotOneThatIsHeld) {
  EXPECT_THAT(add({"joint.*.damping"}, {"", "viscous_friction", {"joint.lower"}, {}, {"damping"}}), IsEmpty());
}

/// A payload in the centre of mass adds to the mass alone; a free mass takes the inertia along unless told not to.
TEST_F(RedundantEffect, IsAPayloadInTheCentreOfMassWhereAFreeMassIsNothingElse) {
  EffectEntry payload{"", "payload", {"body.lower"}, {{"mass", 0.1}, {"z", -0.3}}, {"x", "y", "z"}};
  EXPECT_THAT(add({"body.lower.mass"}, payload), IsEmpty());
  experiment_.model.declared->bodies[1].inertia_scales_with_mass = false;
  EXPECT_THAT(add({}, payload), HasSubstr("payload has the same influence as body.lower.mass"));
  payload.start["z"] = -0.5;
  EXPECT_THAT(add({}, payload), IsEmpty());
}

}  // namespace
}  // namespace lacuna
