#include "evaluation/model/known_setups.h"
#include "evaluation/model/model_definition.h"

#include "plugins/built_catalog.h"
#include "support/robots.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class RecordedSetups : public testing::Test {
 protected:
  RecordedSetups() {
    experiment_.file = "rig.toml";
    experiment_.model.robot = "declared";
    experiment_.model.declared = one_joint(JointKind::hinge, 1.0);
    experiment_.model.free = {{"body.body.mass", 0.1, 5.0, std::nullopt},
                              {"joint.joint.damping", 0.0, 1.0, std::nullopt}};
    for (const char* name : {"light", "heavy", "test"}) {
      MeasuredFile file{.path = std::string(name) + ".csv"};
      file.key = "target.recording[" + std::to_string(files().size()) + "]";
      file.location = {"rig.toml", 10 + static_cast<int>(files().size()), 1};
      files().push_back(file);
    }
    files()[2].held_out = true;
  }

  std::vector<MeasuredFile>& files() { return experiment_.target.recording.files; }
  void set(std::size_t file, const std::string& address, double value) {
    files()[file].setup.name = files()[file].path.stem().string();
    files()[file].setup.values.push_back({address, value});
  }
  void own(std::size_t file, const std::string& pattern) {
    files()[file].setup.name = files()[file].path.stem().string();
    files()[file].own.push_back(pattern);
  }

  ModelDefinition define() const { return define_model(experiment_, built_catalog()); }
  std::vector<std::string> addresses() const {
    std::vector<std::string> all;
    for (const FreeValue& value : define().free) all.push_back(value.address);
    return all;
  }
  std::string problem() const {
    try {
      define();
    } catch (const BadInput& error) {
      return error.what();
    }
    return "none";
  }
  Experiment experiment_;
};

TEST_F(RecordedSetups, NoneLeaveTheModelAlone) {
  EXPECT_THAT(addresses(), ElementsAre("body.body.mass", "joint.joint.damping"));
  EXPECT_TRUE(define().structure.setups.empty());
}

TEST_F(RecordedSetups, AnOwnValueHasTheBoundsAndTheStartOfAll) {
  experiment_.model.free[0].start = 2.0;
  own(1, "body.body.mass");
  EXPECT_THAT(addresses(), ElementsAre("body.body.mass", "joint.joint.damping", "body.body.mass@heavy"));
  const ModelDefinition model = define();
  EXPECT_EQ(model.free[2].upper, 5.0);
  EXPECT_EQ(model.free[2].start, 2.0);
  EXPECT_EQ(model.structure.parameters[2].address, "body.body.mass");
  EXPECT_EQ(model.structure.parameters[2].setup, "heavy");
}

TEST_F(RecordedSetups, APatternSetsEveryValueThatItMeans) {
  set(0, "body.*.mass", 0.7);
  EXPECT_EQ(define().structure.setups, (std::vector<lacuna::Setup>{{"light", {{"body.body.mass", 0.7}}}}));
}

TEST_F(RecordedSetups, AValueThatNoRecordingSharesIsNotFree) {
  own(0, "body.body.mass");
  own(1, "body.body.mass");
  set(2, "body.body.mass", 1.5);
  EXPECT_THAT(addresses(), ElementsAre("joint.joint.damping", "body.body.mass@light", "body.body.mass@heavy"));
}

TEST_F(RecordedSetups, AHeldOutRecordingMustBeToldWhatAllOthersFindForThemselves) {
  own(0, "body.body.mass");
  own(1, "body.body.mass");
  EXPECT_THAT(problem(), HasSubstr("rig.toml:12:1: every fit recording has its own value of body.body.mass, so the "
                                   "value of this held-out recording is unknown"));
}

TEST_F(RecordedSetups, AFreeValueThatEveryRecordingSetsIsAProblem) {
  for (const std::size_t file : {std::size_t{0}, std::size_t{1}}) set(file, "body.body.mass", 1.0);
  EXPECT_THAT(problem(), HasSubstr("body.body.mass is set by every fit recording"));
}

TEST_F(RecordedSetups, AHeldOutRecordingHasNoOwnValues) {
  own(2, "body.body.mass");
  EXPECT_THAT(problem(), HasSubstr("target.recording[2].own[0]: the recording is held out"));
}

TEST_F(RecordedSetups, BoundsMustBeGiven) {
  own(1, "joint.joint.stiffness");
  EXPECT_THAT(problem(), HasSubstr("joint.joint.stiffness has no bounds for the fit"));
}

TEST_F(RecordedSetups, BadAddressesAndValuesAreNamedAllAtOnce) {
  set(0, "body.bdy.mass", 1.0);
  set(1, "body.body.mass", -1.0);
  own(1, "body.body.mass");
  const std::string problems = problem();
  EXPECT_THAT(problems, HasSubstr("target.recording[0].set.body.bdy.mass: \"body.bdy.mass\" matches no value"));
  EXPECT_THAT(problems, HasSubstr("did you mean"));
  EXPECT_THAT(problems, HasSubstr("-1.00 kg is not a possible value of body.body.mass"));
  EXPECT_THAT(problems, HasSubstr("body.body.mass is already set by this recording"));
}

TEST_F(RecordedSetups, AnEffectMayHaveAValueOfARecording) {
  experiment_.model.effects.push_back({"home", "sensor_offset", {"sensor.position"}, {}, {}});
  own(1, "effect.home.offset");
  EXPECT_THAT(addresses(),
              ElementsAre("body.body.mass", "joint.joint.damping", "effect.home.offset", "effect.home.offset@heavy"));
}

TEST_F(RecordedSetups, AreKnownOnceInTheOrderOfTheFile) {
  EXPECT_EQ(known_setups(define(), experiment_.target.recording).size(), 1U);
  EXPECT_FALSE(any_is_set(known_setups(define(), experiment_.target.recording)));
  set(0, "body.*.mass", 0.7);
  set(2, "body.body.mass", 0.7);
  own(1, "body.body.mass");
  const std::vector<KnownSetup> known = known_setups(define(), experiment_.target.recording);
  ASSERT_EQ(known.size(), 2U) << "light and test set the same";
  EXPECT_THAT(known[0].names, ElementsAre("light", "test"));
  EXPECT_THAT(known[0].recordings, ElementsAre("light.csv", "test.csv"));
  EXPECT_EQ(setup_text(known[0]), "setup light (body.body.mass = 0.7 kg)");
  EXPECT_EQ(setup_text(known[1]), "setup heavy (body.body.mass fitted to this setup only)");
  EXPECT_EQ(find_setup(known, "test"), known[0]);
}

TEST_F(RecordedSetups, IncludeTheModelAsItIsWhereARecordingHasNone) {
  set(1, "body.body.mass", 0.7);
  const std::vector<KnownSetup> known = known_setups(define(), experiment_.target.recording);
  ASSERT_EQ(known.size(), 2U);
  EXPECT_EQ(find_setup(known, "none"), known[0]);
  EXPECT_EQ(setup_to_type(known[0]), "none");
  EXPECT_EQ(setup_text(known[0]), "no setup (values of the model)");
  EXPECT_THAT([&] { find_setup(known, "heavi"); },
              testing::ThrowsMessage<BadInput>(
                  testing::AllOf(HasSubstr("did you mean \"heavy\"?"),
                                 HasSubstr("none (values of the model); heavy (body.body.mass = 0.7 kg)"))));
}

}  // namespace
}  // namespace lacuna
