#include "documents/diagnosis_json.h"

#include <lacuna/error.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <set>
#include <string>

namespace lacuna {
namespace {

FoundEffect friction() { return {"coulomb_friction", "joint.hinge", {{"torque", "N*m", 1.0 / 3.0, 0.1, 0.5}}, {}}; }

FoundEffect drag() {
  return {"quadratic_drag", "body.arm", {{"area", "m^2", 0.02, 0.01, 0.03}}, {{"density", "kg/m^3", 1.25}}};
}

ForceFormula formula() { return {"hinge", "N*m", {{"v*abs(v)", "rad^2/s^2", -0.0213, 2e-17}}, {5, 1, 3, 7}}; }

KnownSetup heavy() {
  return {{"heavy", "heavier"}, {{"body.load.mass", 0.49, "kg"}}, {"joint.hinge.damping"}, {"heavy.csv"}};
}

/// Every field has a value that no other has and that is not its own when nothing is said.
Diagnosis filled() {
  Diagnosis whole;
  whole.verdict = Verdict::effect_found;
  whole.probability = 0.91;
  whole.calibrated = true;
  whole.method = DiagnosisMethod::prediction;
  whole.evidence = {{"lead", 2.5}};
  whole.horizons = {{0.1, "angle", "rad", 1e-4, 2e-4, 3e-4, 4e-4, 5e-4}};
  whole.base = {{"angle", "rad", 1e-3, 2e-3, 3e-3}};
  whole.base_times_floor = 12.1;
  whole.base_segment = 0.25;
  whole.ranking = {{{friction(), drag()},
                    {"a @ joint.hinge"},
                    {1.5, 0.5, 1.1, 1.9},
                    {{"angle", "rad", 4e-3, 5e-3, 6e-3}},
                    1.2,
                    0.5}};
  whole.values = {{"body.arm.mass", "kg", 1.5, 1.4, 1.6}};
  whole.p_by_chance = 0.0005;
  whole.answer_gain = {9.0, 0.75, 7.5, 10.5};
  whole.missing_force = {
      {"elbow", "position", "rad", "N*m", {-2.0, 2.0}, {0.3, 0.4}, {0.03, 0.04}, std::nullopt, {0.5, 0.6}}};
  whole.unexplained = {"hinge", "velocity", 0.125, {2.0, 1.0, 0.04, 3.96}};
  whole.residual_force = {{"hinge", "velocity", "rad/s", "N*m", {-1.0, 1.0}, {0.1, 0.2}, {0.01, 0.02}, 0.3}};
  whole.formulas = {formula()};
  whole.hypotheses = 47;
  whole.effect_filter = {"coulomb_friction", "wrong_value"};
  whole.untestable = {{"slope", "world", "the robot has no ground to touch"}};
  whole.findings = {"a sentence"};
  whole.next_test = "steps motor 1 N*m";
  whole.next_test_setup = heavy();
  whole.next_test_worth = "20 nats per trial";
  whole.stopped = StoppedSearch{"refits of candidates", {"b @ joint.hinge"}, "run it again"};
  whole.seconds = 12.5;
  return whole;
}

/// A new member of `Diagnosis` does not compile here until it is written, read and compared.
TEST(DiagnosisJson, KeepsEveryField) {
  const Diagnosis whole = filled();
  const auto [verdict, probability, calibrated, method, evidence, horizons, base, base_times_floor, base_segment,
              ranking, values, p_by_chance, answer_gain, missing_force, unexplained, residual_force, formulas,
              hypotheses, effect_filter, untestable, findings, next_test, next_test_setup, next_test_worth, stopped,
              seconds] = read_diagnosis(diagnosis_json(whole));
  EXPECT_EQ(verdict, whole.verdict);
  EXPECT_EQ(probability, whole.probability);
  EXPECT_EQ(calibrated, whole.calibrated);
  EXPECT_EQ(method, whole.method);
  EXPECT_EQ(evidence, whole.evidence);
  EXPECT_EQ(horizons, whole.horizons);
  EXPECT_EQ(base, whole.base);
  EXPECT_EQ(base_times_floor, whole.base_times_floor);
  EXPECT_EQ(base_segment, whole.base_segment);
  EXPECT_EQ(ranking, whole.ranking);
  EXPECT_EQ(values, whole.values);
  EXPECT_EQ(p_by_chance, whole.p_by_chance);
  EXPECT_EQ(answer_gain, whole.answer_gain);
  EXPECT_EQ(missing_force, whole.missing_force);
  EXPECT_EQ(unexplained, whole.unexplained);
  EXPECT_EQ(residual_force, whole.residual_force);
  ASSERT_EQ(formulas.size(), 1U);
  EXPECT_EQ(formulas.front().joint, formula().joint);
  EXPECT_EQ(formulas.front().unit, formula().unit);
  EXPECT_EQ(formulas.front().terms, formula().terms);
  EXPECT_EQ(formulas.front().gain, formula().gain);
  EXPECT_EQ(hypotheses, whole.hypotheses);
  EXPECT_EQ(effect_filter, whole.effect_filter);
  ASSERT_EQ(untestable.size(), 1U);
  EXPECT_EQ(untestable, whole.untestable);
  EXPECT_EQ(findings, whole.findings);
  EXPECT_EQ(next_test, whole.next_test);
  EXPECT_EQ(next_test_setup, whole.next_test_setup);
  EXPECT_EQ(next_test_worth, whole.next_test_worth);
  EXPECT_EQ(stopped, whole.stopped);
  EXPECT_EQ(seconds, whole.seconds);
}

TEST(DiagnosisJson, KeepsEveryVerdictAndMethod) {
  for (const Verdict verdict :
       {Verdict::nothing_missing, Verdict::effect_found, Verdict::not_in_library, Verdict::cannot_tell})
    for (const auto method : {DiagnosisMethod::prediction, DiagnosisMethod::horizon, DiagnosisMethod::likelihood}) {
      Diagnosis whole;
      whole.verdict = verdict;
      whole.method = method;
      const Diagnosis read = read_diagnosis(diagnosis_json(whole));
      EXPECT_EQ(read.verdict, verdict);
      EXPECT_EQ(read.method, method);
    }
}

/// Documents that earlier versions kept in databases have fewer keys, and some of other names.
TEST(DiagnosisJson, ReadsADocumentOfAnEarlierVersion) {
  nlohmann::ordered_json early = nlohmann::ordered_json::parse(diagnosis_json(filled()));
  for (const char* newer : {"method", "calibrated", "evidence", "horizons", "values", "answer_gain", "next_test_setup",
                            "stopped", "effect_filter"})
    ASSERT_EQ(early.erase(newer), 1U) << newer;
  early["next_test_setup"] = nullptr;
  for (nlohmann::ordered_json* model : {&early["base"], &early["ranking"][0]}) {
    (*model)["cv_rmse"] = (*model)["held_out_rmse"];
    (*model)["ratio_to_floor"] = (*model)["fitted_ratio_to_floor"];
    model->erase("held_out_rmse");
    model->erase("fitted_ratio_to_floor");
  }
  const Diagnosis read = read_diagnosis(early.dump());
  EXPECT_EQ(read.verdict, Verdict::effect_found);
  EXPECT_EQ(read.method, DiagnosisMethod::likelihood);
  EXPECT_EQ(read.ranking, filled().ranking);
  EXPECT_EQ(read.answer_gain, filled().ranking.front().gain);
  EXPECT_FALSE(read.stopped);
}

std::set<std::string> keys_of(const nlohmann::json& document) {
  std::set<std::string> keys;
  for (const auto& [key, value] : document.items()) keys.insert(key);
  return keys;
}

/// A key that is there says that its value was computed.
TEST(DiagnosisJson, LeavesOutWhatWasNotAsked) {
  const std::set<std::string> always = {"verdict",         "probability",  "calibrated", "evidence",
                                        "noise_floor",     "units",        "ranking",    "values",
                                        "hypotheses",      "findings",     "next_test",  "next_test_setup",
                                        "next_test_worth", "not_testable", "seconds",    "effect_filter"};
  Diagnosis nothing;
  EXPECT_EQ(keys_of(nlohmann::json::parse(diagnosis_json(nothing))), always) << "nothing was searched";
  EXPECT_EQ(read_diagnosis(diagnosis_json(nothing)).method, std::nullopt);
  std::set<std::string> searched = always;
  searched.insert({"method", "base", "horizons"});
  nothing.method = DiagnosisMethod::prediction;
  EXPECT_EQ(keys_of(nlohmann::json::parse(diagnosis_json(nothing))), searched);
}

TEST(DiagnosisJson, TellsAnUnknownNumberAsNull) {
  Diagnosis whole;
  whole.probability = std::numeric_limits<double>::quiet_NaN();
  const std::string written = diagnosis_json(whole);
  EXPECT_THAT(written, testing::HasSubstr("\"probability\": null"));
  EXPECT_TRUE(std::isnan(read_diagnosis(written).probability));
}

TEST(DiagnosisJson, RefusesADocumentThatNestsTooDeep) {
  std::string written = diagnosis_json(filled());
  const std::string deep = std::string(80'000, '[') + std::string(80'000, ']');
  written.replace(written.find("findings"), 1, "F");  // the last of two counts
  written.replace(written.find('{'), 1, "{\"findings\": " + deep + ", ");
  EXPECT_THROW(read_diagnosis(written), Error);
}

}  // namespace
}  // namespace lacuna
