#include "diagnosis/diagnosis.h"

#include "config/experiment_reader.h"
#include "diagnosis/recorded_hopper.h"
#include "plugins/built_catalog.h"
#include "support/test_folder.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr std::size_t kTrials = 10;
constexpr double kDuration = 0.4;  // s
constexpr double kTold = 0.15;     // of the hidden value, that an estimate may be off by

/// The hopper's recordings, and the model of it without anything hidden.
class HopperDiagnosis : public testing::Test {
 protected:
  HopperDiagnosis() {
    folder_.write("hopper.toml", hopper_robot_file());
    const std::string text =
        "[experiment]\nname = \"hopper\"\n[target]\nkind = \"simulated\"\nfile = \"hopper.toml\"\n" + hopper_model();
    experiment_ = read_experiment_text(text, folder_ / "rig.toml");
    definition_ = define_model(experiment_, built_catalog());
    model_ = compile(definition_.structure, definition_.engine);
  }

  Diagnosis diagnose_with(const HopperTruth& truth) const {
    return diagnose({.experiment = experiment_,
                     .catalog = built_catalog(),
                     .definition = definition_,
                     .model = *model_,
                     .trials = hopper_trials(truth, kTrials, kDuration),
                     .values = definition_.start_values(),
                     .among = {"restitution", "viscous_friction"},
                     .threads = 2});
  }

  TestFolder folder_;
  Experiment experiment_;
  ModelDefinition definition_;
  std::unique_ptr<CompiledModel> model_;
};

TEST_F(HopperDiagnosis, FindsWhatTheLegLosesThoughNobodyMeasuresTheTrunk) {
  HopperTruth truth;
  truth.viscous = 20.0;
  const Diagnosis diagnosis = diagnose_with(truth);
  ASSERT_EQ(diagnosis.verdict, Verdict::effect_found) << testing::PrintToString(diagnosis.findings);
  const FoundEffect& found = diagnosis.ranking.front().effects.front();
  EXPECT_EQ(found.effect, "viscous_friction");
  EXPECT_EQ(found.where, "joint.leg");
  EXPECT_NEAR(found.parameters.front().value, truth.viscous, kTold * truth.viscous);
  EXPECT_THAT(diagnosis.findings, Contains(HasSubstr("joint.rail has no measured position")));
}

TEST_F(HopperDiagnosis, NamesNoEffectWhereNothingIsHiddenThoughTheGroundIsIntegratedOtherwise) {
  const Diagnosis diagnosis = diagnose_with({});
  EXPECT_TRUE(diagnosis.verdict == Verdict::nothing_missing || diagnosis.verdict == Verdict::cannot_tell)
      << testing::PrintToString(diagnosis.findings);
  EXPECT_GT(diagnosis.hypotheses, 0U);
}

}  // namespace
}  // namespace lacuna
