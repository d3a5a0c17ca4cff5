#include "report/text/diagnosis_text.h"

#include "documents/diagnosis_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lacuna {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

RankedModel friction() {
  RankedModel model;
  model.effects = {{"coulomb_friction", "joint.hinge", {{"torque", "N*m", 0.131, 0.126, 0.136}}}};
  model.look_alikes = {"stribeck_friction @ joint.hinge"};
  model.gain = {std::log(2.0), 0.1, std::log(1.6), std::log(2.5)};
  model.errors = {{"angle", "rad", 8.4e-4, 9.0e-4, 9.2e-4}};
  model.times_floor = 1.1;
  return model;
}

Diagnosis diagnosis(Verdict verdict) {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  Diagnosis result;
  result.verdict = verdict;
  result.probability = 0.97;
  result.method = DiagnosisMethod::prediction;
  result.base = {{"angle", "rad", 8.4e-4, 9.1e-3, 9.2e-3}};
  result.base_times_floor = 10.8;
  RankedModel other = friction();
  other.effects = {{"viscous_friction", "joint.hinge", {{"damping", "N*m*s/rad", 0.0, kNothing, kNothing}}}};
  other.look_alikes.clear();
  result.ranking = {friction(), other};
  result.answer_gain = friction().gain;
  result.p_by_chance = 0.0005;
  result.residual_force = {
      {"hinge", "velocity", "rad/s", "N*m", {-1.0, 0.0, 1.0}, {0.1, 0.0, -0.1}, {0.01, 0.02, 0.01}}};
  result.residual_force.push_back(result.residual_force.front());
  result.residual_force.back().position = -0.8;
  result.formulas = {{"hinge",
                      "N*m",
                      {{"v*abs(v)", "rad^2/s^2", -0.0105, 0.0002}},
                      {std::log(4.0), 0.1, std::log(3.2), std::log(5.0)}}};
  result.hypotheses = 43;
  result.untestable = {{"slope", "", "the robot has no ground to touch"}};
  result.findings = {"body.arm.mass (0.56 kg → 0.50 kg) had absorbed the effect"};
  result.next_test = "triangle motor 0.3 N*m 0.1 Hz 20 s";
  result.next_test_worth = result.next_test + ": 12 nats per trial";
  result.seconds = 31.0;
  return result;
}

TEST(DiagnosisText, TellsAFailureOfAPluginApartFromWhatHasNoPlace) {
  Diagnosis found = diagnosis(Verdict::effect_found);
  found.untestable.push_back({"own_drag", "joint.hinge", "add_loads threw std::runtime_error (no table)", true});
  const std::string text = diagnosis_text(found, "rig.toml");
  EXPECT_THAT(text, HasSubstr("plugin failed: own_drag @ joint.hinge (add_loads threw std::runtime_error (no table))\n"
                              "not testable: slope (the robot has no ground to touch)\n"));
}

TEST(DiagnosisText, AddsNothingWhereTheReadingsAreToBeCorrectedFirst) {
  const std::string text = diagnosis_text(diagnosis(Verdict::effect_found), "rig.toml", " --db other.db",
                                          "under [target.sensors]: angle = { ..., counts_per_turn = 1024 }");
  EXPECT_THAT(text, HasSubstr("→ correct the readings first, under [target.sensors]: angle = { ..., counts_per_turn = "
                              "1024 }, then lacuna diagnose rig.toml --db other.db\n"));
  EXPECT_THAT(text, Not(HasSubstr("lacuna add")));
}

TEST(DiagnosisText, TellsErrorsByHorizonAndAddsAllEffectsAtOnce) {
  Diagnosis found = diagnosis(Verdict::effect_found);
  found.probability = std::numeric_limits<double>::quiet_NaN();
  found.horizons = {{0.1, "angle", "rad", 1e-3, 12.1e-3, 0.9e-3, 13e-3, 1.3e-3}};
  found.ranking.front().effects.push_back({"quadratic_drag", "body.arm", {}});
  const std::string text = diagnosis_text(found, "rig.toml");
  EXPECT_THAT(text, HasSubstr("verdict effect_found\n"));
  EXPECT_THAT(text,
              ContainsRegex("angle, 0.10 s segments +12.1 mrad → 900 µrad +−92.6 % +13.0 mrad → 1.30 mrad +−90 % "));
  EXPECT_THAT(text, HasSubstr("−50 % [−60 %, −38 %]"));
  EXPECT_THAT(text, HasSubstr("→ lacuna add rig.toml --answer\n"));
}

/// Databases keep what earlier versions found, whose gains have another meaning.
TEST(DiagnosisText, TellsGainsOfLikelihoodsInNats) {
  Diagnosis early = diagnosis(Verdict::effect_found);
  early.method = DiagnosisMethod::likelihood;
  early.ranking.front().gain = {2140.0, 80.0, 1980.0, 2300.0};
  EXPECT_THAT(diagnosis_text(early, "rig.toml"), HasSubstr("+2140 ± 157 nats  1.1 × floor"));
}

TEST(DiagnosisText, SaysWhatToAddWithItsValueAndInterval) {
  const std::string text = diagnosis_text(diagnosis(Verdict::effect_found), "rig.toml");
  EXPECT_THAT(text, HasSubstr("verdict effect_found · probability 0.97 (uncalibrated)"));
  EXPECT_THAT(text, HasSubstr("torque 0.131 [0.126, 0.136] N·m"));
  EXPECT_THAT(text, HasSubstr("indistinguishable on these data: stribeck_friction @ joint.hinge"));
  EXPECT_THAT(text, HasSubstr("−50 % [−60 %, −38 %]   1.1 × floor"));
  EXPECT_THAT(
      text,
      HasSubstr("43 candidates tried; probability that noise alone gives a gain as large as the best one: p = 0.0005\n"
                "error of the null model: "));
  EXPECT_THAT(text, Not(HasSubstr("--among")));
  EXPECT_THAT(text, HasSubstr("slope (the robot has no ground to touch)"));
  EXPECT_THAT(text, HasSubstr("next test, to separate coulomb_friction @ joint.hinge from the nearest other candidate: "
                              "triangle motor 0.3 N*m 0.1 Hz 20 s: 12 nats per trial"));
  EXPECT_THAT(text, HasSubstr("→ lacuna add rig.toml coulomb_friction --where joint.hinge\n"));
}

TEST(DiagnosisText, NamesTheEffectFilter) {
  Diagnosis filtered = diagnosis(Verdict::nothing_missing);
  filtered.effect_filter = {"coulomb_friction", "backlash"};
  EXPECT_THAT(
      diagnosis_text(filtered, "rig.toml"),
      HasSubstr("43 candidates tried (only --among coulomb_friction backlash; leave it out to try all effects)"));
  EXPECT_EQ(read_diagnosis(diagnosis_json(filtered)).effect_filter, filtered.effect_filter);
}

TEST(DiagnosisText, SaysWhichValueIsHeldBesideTheOneThatIsTold) {
  Diagnosis of_drag = diagnosis(Verdict::effect_found);
  of_drag.ranking.front().effects = {
      {"quadratic_drag", "body.arm", {{"area", "m^2", 0.02, 0.01, 0.03}}, {{"density", "kg/m^3", 1.2}}}};
  EXPECT_THAT(diagnosis_text(of_drag, "rig.toml"),
              HasSubstr("quadratic_drag: area 0.02 [0.01, 0.03] m²; density held at 1.20 kg/m³: only its product with "
                        "area is determined"));
}

TEST(DiagnosisText, SaysWhatTheRobotFileHasInsteadOfAWrongValue) {
  Diagnosis of_value = diagnosis(Verdict::effect_found);
  of_value.ranking.front().effects = {
      {"wrong_value", "joint.hinge.armature", {{"armature", "kg*m^2", 0.01, 0.0095, 0.0105, 0.02}}}};
  const std::string text = diagnosis_text(of_value, "rig.toml");
  EXPECT_THAT(text, HasSubstr("1  wrong_value @ joint.hinge.armature"));
  EXPECT_THAT(text, HasSubstr("joint.hinge.armature: 0.01 [0.0095, 0.0105] kg·m² instead of 0.0200 kg·m²"));
  EXPECT_THAT(text, HasSubstr("→ lacuna add rig.toml wrong_value --where joint.hinge.armature\n"));
  EXPECT_EQ(read_diagnosis(diagnosis_json(of_value)).ranking.front().effects, of_value.ranking.front().effects);
}

TEST(DiagnosisText, SaysThatAValueIsAtABound) {
  Diagnosis at_bound = diagnosis(Verdict::effect_found);
  FoundParameter& torque = at_bound.ranking.front().effects.front().parameters.front();
  torque.lower_95 = torque.upper_95 = std::nan("");
  torque.at_bound = true;
  EXPECT_THAT(diagnosis_text(at_bound, "rig.toml"), HasSubstr("torque 0.131 N·m (at a bound of its range)"));
  EXPECT_TRUE(read_diagnosis(diagnosis_json(at_bound)).ranking.front().effects.front().parameters.front().at_bound);
}

TEST(DiagnosisText, ProposesATestInItsSetup) {
  Diagnosis loads = diagnosis(Verdict::effect_found);
  EXPECT_THAT(diagnosis_text(loads, "rig.toml"), Not(HasSubstr("--setup")));
  loads.next_test_setup =
      KnownSetup{.names = {"heavy"}, .settings = {{"body.load.mass", 0.49, "kg"}}, .own = {"sensor.angle.offset"}};
  EXPECT_THAT(diagnosis_text(loads, "rig.toml"),
              HasSubstr("→ lacuna trial rig.toml --test 'triangle motor 0.3 N*m 0.1 Hz 20 s' --setup heavy "
                        "--csv=next.csv\n"));
  EXPECT_EQ(read_diagnosis(diagnosis_json(loads)).next_test_setup, loads.next_test_setup);
}

TEST(DiagnosisText, SaysWhatToAddWithTheOptionsOfTheCommand) {
  EXPECT_THAT(diagnosis_text(diagnosis(Verdict::effect_found), "rig.toml", " --db other.db"),
              HasSubstr("→ lacuna add rig.toml coulomb_friction --where joint.hinge --db other.db\n"));
}

TEST(DiagnosisText, SaysThatTheAnswerOfAnUnfinishedSearchIsNotFinal) {
  const char* unfinished =
      "the search was not finished, so another effect may be the answer: to finish it, run lacuna diagnose rig.toml "
      "--db other.db again; to add the best so far:\n→ lacuna add rig.toml coulomb_friction --where joint.hinge --db "
      "other.db\n";
  Diagnosis found = diagnosis(Verdict::effect_found);
  EXPECT_THAT(diagnosis_text(found, "rig.toml", " --db other.db"), Not(HasSubstr("not finished")));
  found.stopped = StoppedSearch{"the search", {"joint_spring @ joint.hinge"}, "Run the same command again."};
  EXPECT_THAT(diagnosis_text(found, "rig.toml", " --db other.db"), HasSubstr(unfinished));
}

TEST(DiagnosisText, ShowsAsManyDigitsAsTheIntervalDeserves) {
  Diagnosis sharp = diagnosis(Verdict::effect_found);
  sharp.ranking.front().effects = {{"torque_gain", "actuator.motor", {{"gain", "1", 0.99837, 0.99812, 0.99862}}}};
  EXPECT_THAT(diagnosis_text(sharp, "rig.toml"), HasSubstr("gain 0.99837 [0.99812, 0.99862]\n"));
}

TEST(DiagnosisText, AddsNothingWhereNothingIsMissing) {
  EXPECT_THAT(diagnosis_text(diagnosis(Verdict::nothing_missing), "rig.toml"), Not(HasSubstr("lacuna add")));
}

TEST(DiagnosisText, ProposesThePluginOfAForceThatNoEffectHas) {
  const std::string text = diagnosis_text(diagnosis(Verdict::not_in_library), "rig.toml");
  EXPECT_THAT(text, HasSubstr("torque on joint.hinge: -0.0105*v*abs(v) N·m   −75 % [−80 %, −69 %] cross-validated"));
  EXPECT_LT(text.find("torque on joint.hinge"), text.find("coulomb_friction @ joint.hinge"))
      << "the answer stands first";
  EXPECT_THAT(text, HasSubstr("→ lacuna plugins new effect NAME --formula '-0.0105*v*abs(v)'\n"));
}

TEST(DiagnosisText, TellsWhatAnAnswerLeavesBehindIt) {
  const std::string text = diagnosis_text(diagnosis(Verdict::effect_found), "rig.toml");
  EXPECT_THAT(text, HasSubstr("residual torque:\ntorque on joint.hinge: -0.0105*v*abs(v) N·m"));
  EXPECT_LT(text.find("coulomb_friction @ joint.hinge"), text.find("torque on joint.hinge"));
  EXPECT_THAT(text, Not(HasSubstr("lacuna plugins new effect")));
}

TEST(DiagnosisText, StatesNoProbabilityWhereItCannotTell) {
  Diagnosis result = diagnosis(Verdict::cannot_tell);
  result.probability = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(diagnosis_text(result, "rig.toml"), StartsWith("verdict cannot_tell\n"));
  EXPECT_THAT(diagnosis_json(result), HasSubstr("\"probability\": null"));
}

/// The database keeps the document; what is read from it prints the same.
TEST(DiagnosisJson, IsReadAgain) {
  for (const Verdict verdict :
       {Verdict::nothing_missing, Verdict::effect_found, Verdict::not_in_library, Verdict::cannot_tell}) {
    const std::string document = diagnosis_json(diagnosis(verdict));
    const Diagnosis again = read_diagnosis(document);
    EXPECT_EQ(diagnosis_json(again), document);
    EXPECT_EQ(diagnosis_text(again, "rig.toml"), diagnosis_text(diagnosis(verdict), "rig.toml"));
  }
}

}  // namespace
}  // namespace lacuna
