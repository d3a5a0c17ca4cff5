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

FoundEffect friction() { return {"coulomb_friction", "joint.hinge", {{"torque", "N*m", 1.0 / 3.0, 0.1, 0.5}}}; }

ForceFormula formula() { return {"hinge", "N*m", {{"v*abs(v)", "rad^2/s^2", -0.0213, 2e-17}}, {5, 1, 3, 7}, {}}; }

KnownSetup heavy() {
  return {{"heavy", "heavier"}, {{"body.load.mass", 0.49, "kg"}}, {"joint.hinge.damping"}, {"heavy.csv"}};
}

/// Every field has a value that no other has and that is not its own when nothing is said.
Diagnosis filled() {
  Diagnosis whole;
  whole.verdict = Verdict::effect_found;
  whole.probability = 0.91;
  whole.at_threshold = {{"held-out gain", FigureUnit::percent, 0.949, 0.95, 0.94, 0.96, Verdict::not_in_library}};
  whole.form_only = true;
  whole.calibrated = true;
  whole.evidence = {{"lead", 2.5}};
  whole.horizons = {{0.1, "angle", "rad", 1e-4, 2e-4, 3e-4, 4e-4, 5e-4}};
  whole.base = {{"angle", "rad", 1e-3, 2e-3, 3e-3}};
  whole.base_times_floor = 12.1;
  whole.base_segment = 0.25;
  whole.forces = {{"hinge", "N*m", 3e-4, 0.05, true}};
  whole.ranking = {
      {{friction()}, {"a @ joint.hinge"}, {1.5, 0.5, 1.1, 1.9}, 0.8, {{"angle", "rad", 4e-3, 5e-3, 6e-3}}, 1.2, 0.5}};
  whole.values = {{"body.arm.mass", "kg", 1.5, 1.4, 1.6}};
  whole.p_by_chance = 0.0005;
  whole.chance_95 = 5.5;
  whole.free_force_p = 0.2;
  whole.free_force_gain = {4.0, 0.25, 3.5, 4.5};
  whole.answer_gain = {9.0, 0.75, 7.5, 10.5};
  whole.residual_force = {{"hinge", "velocity", "rad/s", "N*m", {-1.0, 1.0}, {0.1, 0.2}, {0.01, 0.02}, 0.3}};
  whole.formulas = {formula()};
  whole.formulas_of_rest = true;
  whole.lengths = {{0.5, {friction()}, 1.25}};
  whole.hypotheses = 47;
  whole.untestable = {{"slope", "world", "the robot has no ground to touch"}};
  whole.findings = {"a sentence"};
  whole.next_test = "steps motor 1 N*m";
  whole.next_test_setup = heavy();
  whole.next_test_worth = "20 nats a trial";
  whole.stopped = StoppedSearch{"refits of candidates", {"b @ joint.hinge"}, "run it again"};
  whole.seconds = 12.5;
  return whole;
}

/// A new member of `Diagnosis` does not compile here until it is written, read and compared.
TEST(DiagnosisJson, KeepsEveryField) {
  const Diagnosis whole = filled();
  const auto [verdict, probability, at_threshold, form_only, calibrated, evidence, horizons, base, base_times_floor,
              base_segment, forces, ranking, values, p_by_chance, chance_95, free_force_p, free_force_gain, answer_gain,
              residual_force, formulas, formulas_of_rest, lengths, hypotheses, untestable, findings, next_test,
              next_test_setup, next_test_worth, stopped, seconds] = read_diagnosis(diagnosis_json(whole));
  EXPECT_EQ(verdict, whole.verdict);
  EXPECT_EQ(probability, whole.probability);
  EXPECT_EQ(at_threshold, whole.at_threshold);
  EXPECT_EQ(form_only, whole.form_only);
  EXPECT_EQ(calibrated, whole.calibrated);
  EXPECT_EQ(evidence, whole.evidence);
  EXPECT_EQ(horizons, whole.horizons);
  EXPECT_EQ(base, whole.base);
  EXPECT_EQ(base_times_floor, whole.base_times_floor);
  EXPECT_EQ(base_segment, whole.base_segment);
  EXPECT_EQ(forces, whole.forces);
  EXPECT_EQ(ranking, whole.ranking);
  EXPECT_EQ(values, whole.values);
  EXPECT_EQ(p_by_chance, whole.p_by_chance);
  EXPECT_EQ(chance_95, whole.chance_95);
  EXPECT_EQ(free_force_p, whole.free_force_p);
  EXPECT_EQ(free_force_gain, whole.free_force_gain);
  EXPECT_EQ(answer_gain, whole.answer_gain);
  EXPECT_EQ(residual_force, whole.residual_force);
  ASSERT_EQ(formulas.size(), 1U);
  EXPECT_EQ(formulas.front().joint, formula().joint);
  EXPECT_EQ(formulas.front().unit, formula().unit);
  EXPECT_EQ(formulas.front().terms, formula().terms);
  EXPECT_EQ(formulas.front().gain, formula().gain);
  EXPECT_EQ(formulas_of_rest, whole.formulas_of_rest);
  EXPECT_EQ(lengths, whole.lengths);
  EXPECT_EQ(hypotheses, whole.hypotheses);
  ASSERT_EQ(untestable.size(), 1U);
  EXPECT_EQ(untestable, whole.untestable);
  EXPECT_EQ(findings, whole.findings);
  EXPECT_EQ(next_test, whole.next_test);
  EXPECT_EQ(next_test_setup, whole.next_test_setup);
  EXPECT_EQ(next_test_worth, whole.next_test_worth);
  EXPECT_EQ(stopped, whole.stopped);
  EXPECT_EQ(seconds, whole.seconds);
}

TEST(DiagnosisJson, KeepsEveryVerdictAndUnit) {
  for (const Verdict verdict :
       {Verdict::nothing_missing, Verdict::effect_found, Verdict::not_in_library, Verdict::cannot_tell})
    for (const FigureUnit unit : {FigureUnit::percent, FigureUnit::nats, FigureUnit::chance, FigureUnit::times_floor}) {
      Diagnosis whole;
      whole.verdict = verdict;
      whole.at_threshold = {{"figure", unit, 1.0, 2.0, 0.5, 2.5, verdict}};
      const Diagnosis read = read_diagnosis(diagnosis_json(whole));
      EXPECT_EQ(read.verdict, verdict);
      EXPECT_EQ(read.at_threshold, whole.at_threshold);
    }
}

/// Documents that earlier versions kept in databases have fewer keys.
TEST(DiagnosisJson, ReadsADocumentWithoutTheNewerKeys) {
  nlohmann::ordered_json early = nlohmann::ordered_json::parse(diagnosis_json(filled()));
  for (const char* newer : {"method", "form_only", "calibrated", "at_threshold", "evidence", "horizons", "values",
                            "segment_lengths", "answer_gain", "formulas_of_rest", "next_test_setup", "stopped"})
    ASSERT_EQ(early.erase(newer), 1U) << newer;
  early["next_test_setup"] = nullptr;
  early["random_forces"][0].erase("slow");
  const Diagnosis read = read_diagnosis(early.dump());
  EXPECT_EQ(read.verdict, Verdict::effect_found);
  EXPECT_EQ(read.answer_gain, filled().ranking.front().gain);
  EXPECT_FALSE(read.stopped);
}

std::set<std::string> keys_of(const nlohmann::json& document) {
  std::set<std::string> keys;
  for (const auto& [key, value] : document.items()) keys.insert(key);
  return keys;
}

/// What a search by horizon or by likelihood leaves, and nothing else.
Diagnosis found_by(DiagnosisMethod method) {
  Diagnosis found;
  found.verdict = Verdict::effect_found;
  found.base = {{"angle", "rad", 1e-3, 2e-3, 3e-3}};
  found.ranking.emplace_back();
  found.ranking.front().effects = {friction()};
  found.ranking.front().gain = {1.5, 0.5, 1.1, 1.9};
  if (method == DiagnosisMethod::horizon) {
    found.horizons = filled().horizons;
    return found;
  }
  found.p_by_chance = 0.0005;
  found.chance_95 = 5.5;
  found.ranking.front().probability = 0.8;
  return found;
}

/// A key that is there says that its value was computed.
TEST(DiagnosisJson, LeavesOutWhatWasNotAsked) {
  const std::set<std::string> both = {"verdict",     "method",    "probability",     "calibrated",      "evidence",
                                      "noise_floor", "units",     "ranking",         "values",          "hypotheses",
                                      "findings",    "next_test", "next_test_setup", "next_test_worth", "not_testable",
                                      "seconds",     "base"};
  std::set<std::string> by_horizon = both, by_likelihood = both;
  by_horizon.insert("horizons");
  by_likelihood.insert({"at_threshold", "random_forces", "segment_lengths", "form_only", "p_by_chance", "chance_95",
                        "formulas", "formulas_of_rest", "residual_force"});
  const auto horizon = nlohmann::json::parse(diagnosis_json(found_by(DiagnosisMethod::horizon)));
  const auto likelihood = nlohmann::json::parse(diagnosis_json(found_by(DiagnosisMethod::likelihood)));
  EXPECT_EQ(keys_of(horizon), by_horizon);
  EXPECT_EQ(keys_of(likelihood), by_likelihood);
  EXPECT_EQ(horizon["method"], "horizon");
  EXPECT_EQ(likelihood["method"], "likelihood");
  EXPECT_EQ(keys_of(horizon["base"]),
            (std::set<std::string>{"fit_rmse", "held_out_rmse", "fitted_ratio_to_floor", "segment_s"}));
  EXPECT_EQ(keys_of(likelihood["base"]), (std::set<std::string>{"fit_rmse", "cv_rmse", "ratio_to_floor", "segment_s"}));
  EXPECT_FALSE(horizon["ranking"][0].contains("probability"));
  EXPECT_TRUE(likelihood["ranking"][0].contains("probability"));
}

TEST(DiagnosisJson, SaysNothingOfErrorsWhereNothingWasSearched) {
  const auto nothing = nlohmann::json::parse(diagnosis_json(Diagnosis()));
  for (const char* key : {"method", "base", "p_by_chance", "chance_95", "free_force", "answer_gain", "formulas"})
    EXPECT_FALSE(nothing.contains(key)) << key;
  EXPECT_EQ(read_diagnosis(nothing.dump()).verdict, Verdict::cannot_tell);
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
  written.replace(written.find("at_threshold"), 1, "A");  // the last of two counts
  written.replace(written.find('{'), 1, "{\"at_threshold\": " + deep + ", ");
  EXPECT_THROW(read_diagnosis(written), Error);
}

}  // namespace
}  // namespace lacuna
