#include "answer/calibration.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lacuna {

extern const char* const kCalibrationDocument;  ///< calibration.json

namespace {

using nlohmann::ordered_json;

Calibration calibration_of(const ordered_json& json) {
  Calibration calibration;
  for (const auto& [verdict, one] : json.items()) {
    VerdictCalibration& to = calibration[verdict];
    to.intercept = one.at("intercept");
    for (const ordered_json& term : one.at("terms"))
      to.terms.push_back({term.at("evidence"), term.at("weight"), term.at("least"), term.at("most")});
  }
  return calibration;
}

ordered_json json_of(const Calibration& calibration) {
  ordered_json json = ordered_json::object();
  for (const auto& [verdict, one] : calibration) {
    ordered_json terms = ordered_json::array();
    for (const CalibrationTerm& term : one.terms)
      terms.push_back(
          {{"evidence", term.evidence}, {"weight", term.weight}, {"least", term.least}, {"most", term.most}});
    json[verdict] = {{"intercept", one.intercept}, {"terms", terms}};
  }
  return json;
}

}  // namespace

double VerdictCalibration::probability(const Evidence& evidence) const {
  double odds = intercept;
  for (const CalibrationTerm& term : terms) {
    const auto known = evidence.find(term.evidence);
    const double value = known == evidence.end() ? 0.5 * (term.least + term.most) : known->second;
    odds += term.weight * std::clamp(value, term.least, term.most);
  }
  return 1.0 / (1.0 + std::exp(-odds));
}

ShippedCalibration read_calibration(const std::string& document) {
  const ordered_json whole = ordered_json::parse(document);
  ShippedCalibration calibration{calibration_of(whole.at("verdicts")), {}};
  for (const auto& [rig, one] : whole.at("without").items()) calibration.without[rig] = calibration_of(one);
  return calibration;
}

std::string calibration_json(const ShippedCalibration& calibration, const std::string& source) {
  ordered_json without = ordered_json::object();
  for (const auto& [rig, one] : calibration.without) without[rig] = json_of(one);
  return ordered_json{{"source", source}, {"verdicts", json_of(calibration.all)}, {"without", without}}.dump(1) + "\n";
}

const ShippedCalibration& shipped_calibration() {
  static const ShippedCalibration shipped = read_calibration(kCalibrationDocument);
  return shipped;
}

void tell_probability(Diagnosis& diagnosis, Evidence evidence) {
  diagnosis.evidence = std::move(evidence);
  const Calibration& calibration = shipped_calibration().all;
  const auto known = calibration.find(std::string(to_string(diagnosis.verdict)));
  if (known == calibration.end()) return;
  diagnosis.probability = known->second.probability(diagnosis.evidence);
  diagnosis.calibrated = true;
}

}  // namespace lacuna
