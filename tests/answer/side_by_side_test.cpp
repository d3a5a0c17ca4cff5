#include "answer/find_missing_effects.h"
#include "config/experiment_reader.h"
#include "data_checks/recorded_pendulum.h"
#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

#include <atomic>
#include <thread>

namespace lacuna {
namespace {

std::atomic<std::int64_t> looks_of_the_limited = 0;
std::int64_t clock_of_the_limited() { return ++looks_of_the_limited; }

/// Diagnoses of a pendulum with a spring that its model lacks, two of them in one process. The clock of the one with
/// the short limit counts looks at it, so that no machine's speed counts.
class SideBySideTest : public testing::Test {
 protected:
  SideBySideTest() {
    experiment_.engine.step = 0.01;
    experiment_.engine.substeps = 8;
    experiment_.noise = {};
    experiment_.model.effects = {};
    definition_ = define_model(experiment_, built_catalog());
    model_ = compile(definition_.structure, definition_.engine);
  }

  Diagnosis diagnosis(const Stop& stop) const {
    return find_missing_effects({.experiment = experiment_,
                                 .catalog = built_catalog(),
                                 .definition = definition_,
                                 .model = *model_,
                                 .trials = trials_,
                                 .among = {"joint_spring", "coulomb_friction"},
                                 .work = {.stop = stop}});
  }

  /// No trial is held out, so that these errors are NaN.
  static void expect_same(const std::vector<ChannelError>& one, const std::vector<ChannelError>& other) {
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_EQ(one[i].fit, other[i].fit);
      EXPECT_EQ(one[i].floor, other[i].floor);
    }
  }

  static void expect_same(const Diagnosis& one, const Diagnosis& other) {
    EXPECT_EQ(one.verdict, other.verdict);
    EXPECT_EQ(one.evidence, other.evidence);
    expect_same(one.base, other.base);
    ASSERT_EQ(one.ranking.size(), other.ranking.size());
    for (std::size_t i = 0; i < one.ranking.size(); ++i) {
      EXPECT_EQ(one.ranking[i].effects, other.ranking[i].effects);
      EXPECT_EQ(one.ranking[i].gain, other.ranking[i].gain);
      EXPECT_EQ(one.ranking[i].times_floor, other.ranking[i].times_floor);
      expect_same(one.ranking[i].errors, other.ranking[i].errors);
    }
    EXPECT_EQ(one.values, other.values);
    EXPECT_EQ(one.findings, other.findings);
    EXPECT_EQ(one.next_test, other.next_test);
  }

  Experiment experiment_ = read_experiment(LACUNA_SOURCE_DIRECTORY "/experiments/first-steps.toml");
  const PendulumTruth truth_{.inertia = 0.03, .damping = 0.02, .spring = 0.4};
  const std::vector<Trial> trials_ = {recorded(truth_, "multi.csv", multisine, 6.0, 3),
                                      recorded(truth_, "steps.csv", steps, 6.0, 4)};
  ModelDefinition definition_;
  std::unique_ptr<CompiledModel> model_;
};

TEST_F(SideBySideTest, EachDiagnosisHasItsOwnTimeLimitAndTheAnswerThatItHasAlone) {
  constexpr double kNever = 1e9;  // s
  TimeLimit never(kNever, "never", clock_of_the_limited);
  const std::int64_t begin = looks_of_the_limited;
  const Diagnosis alone = diagnosis(Stop(never));
  const std::int64_t all = looks_of_the_limited - begin;
  ASSERT_FALSE(alone.stopped);
  ASSERT_EQ(alone.verdict, Verdict::effect_found);

  TimeLimit shorter(1e-3 * 0.5 * static_cast<double>(all), "half", clock_of_the_limited), longer(kNever, "never");
  Diagnosis limited, unlimited;
  {
    const std::jthread one([&] { limited = diagnosis(Stop(shorter)); });
    const std::jthread other([&] { unlimited = diagnosis(Stop(longer)); });
  }
  ASSERT_TRUE(limited.stopped);
  EXPECT_THAT(limited.findings.front(), testing::StartsWith("The search was stopped by --time-limit half"));
  EXPECT_TRUE(shorter.was_reached());
  EXPECT_FALSE(unlimited.stopped);
  EXPECT_FALSE(longer.was_reached());
  expect_same(unlimited, alone);
}

TEST_F(SideBySideTest, ARequestEndsTheDiagnosisThatItIsForAlone) {
  StopRequest request;
  request.make();
  Diagnosis other;
  bool is_interrupted = false;
  {
    const std::jthread one([&] {
      try {
        diagnosis(Stop(request));
      } catch (const TimeIsUp&) {
      } catch (const Interrupted&) {
        is_interrupted = true;
      }
    });
    const std::jthread free([&] { other = diagnosis({}); });
  }
  EXPECT_TRUE(is_interrupted);
  EXPECT_FALSE(other.stopped);
  EXPECT_EQ(other.verdict, Verdict::effect_found);
}

}  // namespace
}  // namespace lacuna
