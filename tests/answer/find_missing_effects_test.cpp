#include "answer/find_missing_effects.h"

#include "config/experiment_reader.h"
#include "data_checks/recorded_pendulum.h"
#include "measurement/trials/recorded_controller.h"
#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr double kFriction = 0.04;  // N·m
const PendulumTruth kDry = {.inertia = 0.03, .damping = 0.02, .friction = kFriction};

/// Diagnoses of the servo pendulum of the first steps, whose model has no effect.
class FindMissingEffects : public testing::Test {
 protected:
  FindMissingEffects() : experiment_(read_experiment(LACUNA_SOURCE_DIRECTORY "/experiments/first-steps.toml")) {
    experiment_.engine.step = 0.01;
    experiment_.engine.substeps = 8;
    experiment_.noise = {};
    experiment_.model.effects = {};
  }

  Diagnosis of(const PendulumTruth& truth, const std::vector<std::string>& among) {
    std::vector<Trial> trials = {recorded(truth, "multi.csv", multisine, 6.0, 3),
                                 recorded(truth, "steps.csv", steps, 6.0, 4),
                                 recorded(truth, "held.csv", multisine, 6.0, 5)};
    trials.back().held_out = true;
    return of(trials, among);
  }

  Diagnosis of(const std::vector<Trial>& trials, const std::vector<std::string>& among) {
    const ModelDefinition definition = define_model(experiment_, built_catalog());
    const std::unique_ptr<CompiledModel> model = compile(definition.structure, definition.engine);
    return find_missing_effects({.experiment = experiment_,
                                 .catalog = built_catalog(),
                                 .definition = definition,
                                 .model = *model,
                                 .trials = trials,
                                 .among = among,
                                 .work = {2}});
  }

 private:
  Experiment experiment_;
};

TEST_F(FindMissingEffects, TellsTheErrorsThatItLowersFittedAndHeldOut) {
  const Diagnosis found = of(kDry, {"coulomb_friction", "joint_spring"});
  ASSERT_EQ(found.verdict, Verdict::effect_found);
  EXPECT_EQ(found.method, DiagnosisMethod::prediction);
  ASSERT_EQ(found.horizons.size(), 5U);
  for (const HorizonError& error : found.horizons) {
    EXPECT_NEAR(error.answer / error.floor, 1.0, 0.15) << error.horizon;
    EXPECT_NEAR(error.answer_held_out / error.floor, 1.0, 0.3) << error.horizon;
  }
  EXPECT_GT(found.horizons.back().base, 5.0 * found.horizons.back().floor);
  EXPECT_GT(found.horizons.back().base_held_out, 5.0 * found.horizons.back().floor);
  EXPECT_NEAR(found.ranking.front().times_floor, 1.0, 0.15);
  EXPECT_GT(found.base_times_floor, 3.0);
  EXPECT_LT(found.p_by_chance.value(), 0.05);
  EXPECT_GT(found.answer_gain.value().lower_95, 0.0);
}

TEST_F(FindMissingEffects, GivesIntervalsThatHoldTheTruth) {
  const Diagnosis found = of(kDry, {"coulomb_friction", "joint_spring"});
  const FoundParameter torque = found.ranking.at(0).effects.at(0).parameters.at(0);
  EXPECT_EQ(torque.unit, "N*m");
  EXPECT_LT(torque.lower_95, kFriction);
  EXPECT_GT(torque.upper_95, kFriction);
  EXPECT_LT(torque.upper_95 - torque.lower_95, 0.2 * kFriction);
  ASSERT_FALSE(found.values.empty());
  EXPECT_EQ(found.values.front().name, "body.arm.mass");
  EXPECT_LT(found.values.front().lower_95, found.values.front().value);
}

TEST_F(FindMissingEffects, SaysThatNothingIsMissing) {
  const Diagnosis found = of({.inertia = 0.03, .damping = 0.02}, {"coulomb_friction", "joint_spring"});
  EXPECT_EQ(found.verdict, Verdict::nothing_missing);
  EXPECT_TRUE(found.formulas.empty());
  EXPECT_NEAR(found.base_times_floor, 1.0, 0.15);
}

TEST_F(FindMissingEffects, SaysThatTheLibraryEndsWithTheFormulaOfWhatItLacks) {
  const Diagnosis found = of({.inertia = 0.03, .damping = 0.02, .cubic = 0.5}, {"coulomb_friction"});
  EXPECT_EQ(found.verdict, Verdict::not_in_library);
  ASSERT_EQ(found.formulas.size(), 1U);
  EXPECT_THAT(found.formulas[0].text(), HasSubstr("q^3"));
  EXPECT_FALSE(found.residual_force.empty());
}

/// The reference is what the command would have been without feedback, as an angle.
TEST_F(FindMissingEffects, TriesTheControllerInTheLoopWhereOneMadeTheCommands) {
  constexpr double kFeedback = 2.0;  // N·m/rad
  Trial trial = recorded({.feedback = kFeedback}, "multi.csv", multisine, 6.0, 3);
  TimeSeries references = trial.commands.series;
  references.samples = (trial.commands.series.samples + kFeedback * trial.measured.samples) / kFeedback;
  trial.controller =
      std::make_shared<RecordedController>(std::vector<ControlLaw>{{.proportional = kFeedback}},
                                           RecordedSignals{references, trial.commands, {0}, trial.measured});
  EXPECT_THAT(of({trial}, {"coulomb_friction"}).findings, Contains(HasSubstr("with the controller in the loop")));
}

TEST_F(FindMissingEffects, NeedsATrialThatIsNotHeldOut) {
  std::vector<Trial> trials = {recorded(kDry, "held.csv", multisine, 2.0, 5)};
  trials.back().held_out = true;
  EXPECT_THROW(of(trials, {}), Error);
}

/// Of a joint that never moves no prediction says anything, and the answer says so.
TEST_F(FindMissingEffects, CannotTellOfAJointThatNeverMoves) {
  const Diagnosis found = of({recorded({.friction = 5.0}, "one.csv", multisine, 2.0, 3)}, {"coulomb_friction"});
  EXPECT_NE(found.verdict, Verdict::not_in_library);
  EXPECT_TRUE(found.verdict == Verdict::cannot_tell || !found.ranking.empty());
}

}  // namespace
}  // namespace lacuna
