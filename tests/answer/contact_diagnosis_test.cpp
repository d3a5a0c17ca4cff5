#include "answer/find_missing_effects.h"

#include "config/experiment_reader.h"
#include "contacts/contact_recording.h"
#include "contacts/write_contact_case.h"
#include "plugins/built_catalog.h"
#include "support/test_folder.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr int kTrials = 10;
constexpr int kSubsteps = 2;  // fewer than the benchmark has, for speed
constexpr std::uint64_t kSeed = 1;
constexpr double kDuration = 0.4;  // s
constexpr double kTold = 0.15;     // of the hidden value, that an estimate may be off by

/// As the program reads a recording of the hopper.
Trial read_as(const hidden_effects::ContactTrial& recorded, const hidden_effects::ContactRig& rig) {
  const auto rows = static_cast<Eigen::Index>(rig.samples());
  const auto column = [&](const std::vector<double>& values) {
    return Eigen::Map<const Eigen::VectorXd>(values.data(), rows);
  };
  Trial trial;
  trial.name = recorded.name;
  trial.measured = {{{"length", "m"}, {"ground", "1"}},
                    Eigen::VectorXd::LinSpaced(rows, 0.0, rig.duration),
                    TimeSeries::Samples(rows, 2)};
  trial.commands.series = {{{"motor", "N"}}, trial.measured.times, TimeSeries::Samples(rows, 1)};
  for (Eigen::Index c = 0; c < 2; ++c)
    trial.measured.samples.col(c) = column(recorded.readings[static_cast<std::size_t>(c)]);
  trial.commands.series.samples.col(0) = column(recorded.commands.front());
  for (const hidden_effects::ContactStart& start : rig.starts)
    trial.initial.push_back({InitialKnowledge::given, start.position, 0.0});
  return trial;
}

/// The hopper's recordings, and the model of it without anything hidden.
class HopperDiagnosis : public testing::Test {
 protected:
  HopperDiagnosis() {
    rig_.duration = kDuration;
    rig_.substeps = kSubsteps;
    hidden_effects::write_contact_robot(rig_, folder_.path());
    experiment_ = read_experiment_text(
        "[experiment]\nname = \"hopper\"\n[target]\nkind = \"simulated\"\nfile = \"robot.toml\"\n" +
            hidden_effects::model_text(rig_, hidden_effects::Integration::owner, {}),
        folder_ / "rig.toml");
    definition_ = define_model(experiment_, built_catalog());
    model_ = compile(definition_.structure, definition_.engine);
  }

  Diagnosis diagnose_with(const std::vector<hidden_effects::SizedContactLaw>& hidden) const {
    const hidden_effects::ContactBench bench(rig_, folder_.path(), hidden, rig_.nominal,
                                             hidden_effects::NoiseLevel::white, kSeed);
    std::vector<Trial> trials;
    for (int number = 0; number < kTrials; ++number) trials.push_back(read_as(bench.record(number), rig_));
    return find_missing_effects({.experiment = experiment_,
                                 .catalog = built_catalog(),
                                 .definition = definition_,
                                 .model = *model_,
                                 .trials = trials,
                                 .among = {"restitution", "viscous_friction"},
                                 .work = {2}});
  }

  TestFolder folder_;
  hidden_effects::ContactRig rig_ = hidden_effects::hopper();
  Experiment experiment_;
  ModelDefinition definition_;
  std::unique_ptr<CompiledModel> model_;
};

TEST_F(HopperDiagnosis, FindsWhatTheLegLosesThoughNobodyMeasuresTheTrunk) {
  constexpr double kHidden = 20.0;  // N·s/m
  const Diagnosis diagnosis =
      diagnose_with({{hidden_effects::contact_law(rig_, "viscous_friction", "joint.leg"), kHidden}});
  ASSERT_EQ(diagnosis.verdict, Verdict::effect_found) << testing::PrintToString(diagnosis.findings);
  const FoundEffect& found = diagnosis.ranking.front().effects.front();
  EXPECT_EQ(found.effect, "viscous_friction");
  EXPECT_EQ(found.where, "joint.leg");
  EXPECT_NEAR(found.parameters.front().value, kHidden, kTold * kHidden);
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
