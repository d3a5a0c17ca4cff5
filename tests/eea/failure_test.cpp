#include "eea/estimation.h"
#include "eea/exploration.h"
#include "eea/small_run.h"
#include "foundation/processes/interrupt.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

using testing::HasSubstr;

/// A target that fails in a way of its own, until it has failed often enough.
template <class Failure>
class FailingTarget : public TargetSystem {
 public:
  FailingTarget(Failure failure, int times) : failure_(std::move(failure)), times_(times) {}
  std::string summary() const override { return "fails"; }
  bool takes_tests() const override { return true; }
  Trial carry_out(const Test& test, const TargetServices& services) override {
    if (asked++ < times_) throw failure_;
    return services.simulator->simulate(test);
  }

  int asked = 0;

 private:
  Failure failure_;
  int times_;
};

/// Carries out the first trial of a run.
template <class Failure>
void first_trial(FailingTarget<Failure>& system, MemoryJournal& journal, EeaState& state, int repeats = 0) {
  const auto bench = small_bench();
  TargetSimulator simulator(*bench->target(), bench->hidden_values(1), 1);
  const EeaRun run{.definition = bench->definition(), .journal = journal, .truth = {}, .progress = {}};
  choose_random_test(run, state, 0);
  carry_out_test(run, {system, {"target", "failing", {}}, &simulator, nullptr, repeats}, state, false);
}

TEST(TargetTrials, ATestThatFailsIsReplaced) {
  FailingTarget system(Error("the rig says no"), 2);
  MemoryJournal journal;
  EeaState state;
  first_trial(system, journal, state);
  EXPECT_EQ(system.asked, 3);
  ASSERT_EQ(journal.failures.size(), 2U);
  EXPECT_EQ(journal.failures[1].trial, "0");
  EXPECT_EQ(journal.failures[1].test, "1");
  EXPECT_THAT(journal.failures[1].reason, HasSubstr("the rig says no"));
  ASSERT_EQ(journal.trial_rows.size(), 1U);
  EXPECT_EQ(journal.trial_rows[0].test, 2U) << "the first two tests failed";
  EXPECT_EQ(state.trials.size(), 1U);
}

TEST(TargetTrials, ATestThatFailsIsRepeatedFirstWhereTheTargetAllowsIt) {
  FailingTarget system(Error("the rig says no"), 3);
  MemoryJournal journal;
  EeaState state;
  first_trial(system, journal, state, 1);
  EXPECT_EQ(system.asked, 4);
  ASSERT_EQ(journal.trial_rows.size(), 1U);
  EXPECT_EQ(journal.trial_rows[0].test, 1U) << "the first test failed twice, the second once";
  EXPECT_EQ(journal.failures.size(), 3U);
}

/// A target whose sensors read what no sensor does, the first time.
class AbsurdTarget : public TargetSystem {
 public:
  std::string summary() const override { return "reads nonsense"; }
  bool takes_tests() const override { return true; }
  Trial carry_out(const Test& test, const TargetServices& services) override {
    Trial trial = services.simulator->simulate(test);
    if (asked++ == 0) trial.measured.samples(1, 0) = -1e308;
    trial.measured.samples(2, 0) = std::numeric_limits<double>::quiet_NaN();  // not measured, which may be
    return trial;
  }

  int asked = 0;
};

TEST(TargetTrials, AReadingThatNoSensorMakesFailsTheTrial) {
  const auto bench = small_bench();
  TargetSimulator simulator(*bench->target(), bench->hidden_values(1), 1);
  AbsurdTarget system;
  MemoryJournal journal;
  EeaState state;
  const EeaRun run = run_of(*bench, journal);
  choose_random_test(run, state, 0);
  carry_out_test(run, {system, {"target", "absurd", {}}, &simulator, nullptr, 0}, state, false);
  EXPECT_EQ(system.asked, 2);
  ASSERT_EQ(journal.failures.size(), 1U);
  EXPECT_THAT(journal.failures[0].reason, HasSubstr("target \"absurd\": it reads more than 1e+12"));
}

TEST(TargetTrials, AnInterruptionAndWrongInputEndTheRunAtOnce) {
  FailingTarget interrupted(Interrupted("the user"), 9);
  FailingTarget misled(BadInput(std::vector<Problem>{{{"rig.toml"}, "is wrong"}}), 9);
  MemoryJournal journal;
  EeaState state;
  EXPECT_THROW(first_trial(interrupted, journal, state), Interrupted);
  EXPECT_THROW(first_trial(misled, journal, state), BadInput);
  EXPECT_EQ(interrupted.asked, 1);
  EXPECT_EQ(misled.asked, 1);
}

/// Refuses genomes whose first gene is in the upper half of its range.
template <class Encoding>
class Picky : public Encoding {
 public:
  explicit Picky(const Encoding& other) : other_(other) {}
  std::string summary() const override { return "refuses some genomes"; }
  ParameterDeclarations parameters() const override { return other_.parameters(); }

 protected:
  const Encoding& other_;
};

class PickyModels : public Picky<ModelEncoding> {
 public:
  using Picky::Picky;
  GenomeLayout layout(const ModelSpace& space, std::span<const double> parameters) const override {
    return other_.layout(space, parameters);
  }
  ModelProposal decode(const ModelSpace& space, std::span<const double> parameters,
                       std::span<const double> genome) const override {
    ModelProposal proposal = other_.decode(space, parameters, genome);
    if (proposal.values[0] > 4.0) throw Error("the torso is too heavy");  // kg; drawn from 1 to 7
    return proposal;
  }
};

class PickyTests : public Picky<TestEncoding> {
 public:
  using Picky::Picky;
  GenomeLayout layout(const TestSpace& space, std::span<const double> parameters) const override {
    return other_.layout(space, parameters);
  }
  Test decode(const TestSpace& space, std::span<const double> parameters,
              std::span<const double> genome) const override {
    if (genome[0] > 0.0) throw Error("the first weight is positive");
    return other_.decode(space, parameters, genome);
  }
};

TEST(Encoding, AGenomeThatItRefusesRanksLastAndEndsNothing) {
  const auto bench = small_bench();
  EeaDefinition definition(bench->opened().experiment, *bench->opened().catalog, bench->opened().definition, true);
  const PickyModels models(*definition.model_encoding.component);
  const PickyTests tests(*definition.test_encoding.component);
  definition.model_encoding.component = &models;
  definition.test_encoding.component = &tests;
  MemoryJournal journal;
  EeaState state = first_state(definition);
  const ReplicateTarget target(*bench, 1, 1);
  eea_loop({.definition = definition, .journal = journal, .truth = {}, .progress = {}}, target.target(), state);
  const auto refused = [](const auto& rows, const char* reason) {
    return std::count_if(rows.begin(), rows.end(),
                         [&](const auto& row) { return row.reason.find(reason) != std::string::npos; });
  };
  EXPECT_GT(refused(journal.models, "the torso is too heavy"), 0);
  EXPECT_GT(refused(journal.tests, "the first weight is positive"), 0);
  EXPECT_EQ(journal.passes.size(), 2U);
}

/// Most inertias of this range are none that a body can have.
TEST(Estimation, HandsOnModelsThatCanBeScored) {
  const auto bench = small_bench({"model.free={\"body.torso.mass\"=[1,7],\"body.torso.inertia.xy\"=[-1,1]}"});
  const MemoryJournal journal = run(*bench);
  const auto valid = std::count_if(journal.models.begin(), journal.models.end(), [](const ModelRow& model) {
    return model.pass == 1 && model.generation == 0 && model.kind == ScoreKind::full;
  });
  ASSERT_LT(valid, 6) << "the test needs fewer valid models than survive";
  std::size_t handed_on = 0;
  for (const std::vector<double>& checkpoint : journal.checkpoints)
    for (const KnownModel& model : load_state(checkpoint).best) {
      EXPECT_TRUE(std::isfinite(model.score));
      ++handed_on;
    }
  EXPECT_GT(handed_on, 0U);
}

}  // namespace
}  // namespace lacuna
