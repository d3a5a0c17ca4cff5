#include "measured_rigs/accepted_answer.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace hidden_effects {
namespace {

const AcceptedAnswer kPendulum{"pendulum",
                               {"pendulum.toml"},
                               {"still.toml"},
                               {{"coulomb_friction"}, {"quadratic_drag", "linear_drag"}},
                               {"viscous_friction"}};

DiagnosisRecord found(const std::vector<EffectAt>& effects, const std::vector<EffectAt>& alike = {}) {
  DiagnosisRecord record;
  record.verdict = "effect_found";
  RankedModelRecord model;
  for (const EffectAt& one : effects) model.effects.push_back({one, {}});
  model.look_alikes = alike;
  record.ranking = {model};
  return record;
}

const EffectAt kCoulomb{"coulomb_friction", "joint.hinge"}, kDrag{"linear_drag", "body.arm"},
    kViscous{"viscous_friction", "joint.hinge"}, kSpring{"joint_spring", "joint.hinge"};

TEST(Grade, NeedsOneOfEachAndAllowsNoOther) {
  const auto graded = [](const DiagnosisRecord& record) { return grade(kPendulum, "pendulum.toml", record); };
  EXPECT_EQ(graded(found({kCoulomb, kDrag})), Grade::right);
  EXPECT_EQ(graded(found({kCoulomb, kDrag, kViscous})), Grade::right);
  EXPECT_EQ(graded(found({kCoulomb})), Grade::wrong) << "the drag is missing";
  EXPECT_EQ(graded(found({kCoulomb, kDrag, kSpring})), Grade::wrong) << "nobody asked for a spring";
  EXPECT_EQ(graded(found({kCoulomb, kSpring}, {kDrag})), Grade::right) << "the spring stands for the drag";
  EXPECT_EQ(graded(found({kSpring, kViscous}, {kDrag})), Grade::wrong) << "nothing stands for the dry friction";
  DiagnosisRecord undecided;
  undecided.verdict = "cannot_tell";
  EXPECT_EQ(graded(undecided), Grade::undecided);
}

TEST(Grade, OfAPlaceIsMetByTheTiedEffect) {
  const AcceptedAnswer arm{
      "arm", {"arm.toml"}, {}, {{"coulomb_friction @ joint.hinge"}, {"coulomb_friction @ joint.elbow"}}, {}};
  EXPECT_EQ(grade(arm, "arm.toml", found({{"coulomb_friction", "joint.*"}})), Grade::right);
  EXPECT_EQ(grade(arm, "arm.toml", found({kCoulomb})), Grade::wrong);
}

TEST(Grade, WhereNothingIsMissing) {
  DiagnosisRecord nothing;
  nothing.verdict = "nothing_missing";
  EXPECT_EQ(grade(kPendulum, "still.toml", nothing), Grade::right);
  EXPECT_EQ(grade(kPendulum, "pendulum.toml", nothing), Grade::wrong);
  EXPECT_EQ(grade(kPendulum, "still.toml", found({kCoulomb, kDrag})), Grade::wrong);
}

TEST(AcceptedAnswers, NameExperimentsThatAreThere) {
  const std::filesystem::path source = LACUNA_SOURCE_DIRECTORY;
  const std::vector<AcceptedAnswer> answers =
      read_accepted_answers(source / "experiments/benchmark/measured_rigs/answers.toml");
  EXPECT_EQ(answers.size(), 15U);
  for (const AcceptedAnswer& one : answers)
    for (const auto& files : {one.experiments, one.nothing_missing})
      for (const std::string& file : files)
        EXPECT_TRUE(std::filesystem::exists(source / "experiments/real" / file)) << one.rig << ": " << file;
}

}  // namespace
}  // namespace hidden_effects
