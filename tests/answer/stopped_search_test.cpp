#include "answer/find_missing_effects.h"
#include "config/experiment_reader.h"
#include "data_checks/recorded_pendulum.h"
#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

#include <atomic>
#include <cmath>

namespace lacuna {
namespace {

std::atomic<std::int64_t> checks_of_limit = 0;
std::int64_t clock_of_checks() { return ++checks_of_limit; }

/// Diagnoses of a pendulum with a spring that its model lacks, stopped after so many looks at the clock.
class StoppedSearchTest : public testing::Test {
 protected:
  StoppedSearchTest() {
    experiment_.engine.step = 0.01;
    experiment_.engine.substeps = 8;
    experiment_.noise = {};
    experiment_.model.effects = {};
  }

  Diagnosis stopped_after(std::int64_t checks, const KeptFits* known = nullptr) {
    const ModelDefinition definition = define_model(experiment_, built_catalog());
    const std::unique_ptr<CompiledModel> model = compile(definition.structure, definition.engine);
    kept_.reset();
    parts_.clear();
    TimeLimit limit(1e-3 * static_cast<double>(checks), "1 s", clock_of_checks);
    const std::int64_t begin = checks_of_limit;
    Diagnosis diagnosis = find_missing_effects(
        {.experiment = experiment_,
         .catalog = built_catalog(),
         .definition = definition,
         .model = *model,
         .trials = trials_,
         .among = {"joint_spring", "coulomb_friction", "joint_offset_torque"},
         .work = {.stop = Stop(limit),
                  .progress = [&](const Progress& now) { parts_.emplace(now.what, spent(begin)); }},
         .known = known,
         .keep = [&](const KeptFits& fits) { kept_ = fits; }});
    used_ = spent(begin);
    return diagnosis;
  }

  static std::int64_t spent(std::int64_t begin) { return checks_of_limit - begin; }

  static std::string answer_of(const Diagnosis& diagnosis) {
    return diagnosis.ranking.empty() ? "" : diagnosis.ranking.front().effects.front().effect;
  }

  static void expect_preliminary(const Diagnosis& diagnosis) {
    ASSERT_TRUE(diagnosis.stopped);
    EXPECT_TRUE(std::isnan(diagnosis.probability));
    ASSERT_GE(diagnosis.findings.size(), 2u);
    EXPECT_THAT(diagnosis.findings[0], testing::StartsWith("The search was stopped by --time-limit 1 s, during: "));
    EXPECT_THAT(diagnosis.findings, testing::Contains(diagnosis.stopped->next));
  }

  Experiment experiment_ = read_experiment(LACUNA_SOURCE_DIRECTORY "/experiments/first-steps.toml");
  const PendulumTruth truth_{.inertia = 0.03, .damping = 0.02, .spring = 0.4};
  const std::vector<Trial> trials_ = {recorded(truth_, "multi.csv", multisine, 6.0, 3),
                                      recorded(truth_, "steps.csv", steps, 6.0, 4)};
  std::map<std::string, std::int64_t> parts_;  ///< looks at the clock before each part first began
  std::optional<KeptFits> kept_;
  std::int64_t used_ = 0;
};

TEST_F(StoppedSearchTest, EndsWithWhatIsKnownWhereverItIsStopped) {
  const Diagnosis whole = stopped_after(1'000'000'000);
  ASSERT_FALSE(whole.stopped);
  ASSERT_EQ(whole.verdict, Verdict::effect_found);
  ASSERT_EQ(answer_of(whole), "joint_spring");
  const std::int64_t all = used_;
  const std::map<std::string, std::int64_t> parts = parts_;

  const Diagnosis before = stopped_after(parts.at("the model as it is") + 1);
  expect_preliminary(before);
  EXPECT_EQ(before.verdict, Verdict::cannot_tell);
  EXPECT_EQ(before.stopped->during, "the fit of the model");
  EXPECT_THAT(before.stopped->not_examined,
              testing::UnorderedElementsAre("joint_spring @ joint.hinge", "coulomb_friction @ joint.hinge",
                                            "joint_offset_torque @ joint.hinge"));
  EXPECT_THAT(before.stopped->next, testing::HasSubstr("a longer --time-limit"));

  const Diagnosis among_first = stopped_after(parts.at("first-order gains of the library") + 1);
  expect_preliminary(among_first);
  EXPECT_EQ(among_first.stopped->during, "the search");
  EXPECT_FALSE(among_first.stopped->not_examined.empty());
  EXPECT_FALSE(among_first.base.empty()) << "the model alone was judged";

  const Diagnosis late =
      stopped_after(parts.at("first-order gains of the library beside joint_spring @ joint.hinge") + 1);
  expect_preliminary(late);
  EXPECT_EQ(late.verdict, Verdict::effect_found);
  EXPECT_EQ(answer_of(late), "joint_spring");

  ASSERT_TRUE(kept_) << "single effects";
  const KeptFits known = *kept_;
  const Diagnosis resumed = stopped_after(1'000'000'000, &known);
  EXPECT_LT(used_, all) << "what was fitted need not be fitted again";
  EXPECT_FALSE(resumed.stopped);
  EXPECT_EQ(resumed.verdict, whole.verdict);
  EXPECT_NEAR(resumed.ranking.front().gain.value, whole.ranking.front().gain.value, 1e-3);
}

TEST_F(StoppedSearchTest, NamesTheCandidatesWhereEvenTheChecksOfTheDataAreStopped) {
  const Diagnosis nothing = stopped_after(0);
  expect_preliminary(nothing);
  EXPECT_EQ(nothing.verdict, Verdict::cannot_tell);
  EXPECT_EQ(nothing.stopped->not_examined.size(), 3u);
}

}  // namespace
}  // namespace lacuna
