#pragma once

#include "answer/diagnosis.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// Weight of one figure of the evidence, and the range it had in the cases that the weights were fitted to.
struct CalibrationTerm {
  std::string evidence;
  double weight = 0.0;
  double least = 0.0, most = 0.0;
};

/// The log odds that a verdict is right.
struct VerdictCalibration {
  double intercept = 0.0;
  std::vector<CalibrationTerm> terms;

  /// A figure beyond its range counts as the nearer end of the range; a missing figure counts as the middle.
  double probability(const Evidence& evidence) const;
};

/// By verdict; a verdict that is not listed has no calibration.
using Calibration = std::map<std::string, VerdictCalibration>;

/// How often verdicts with such evidence were right in cases whose missing effect was known: a logistic regression (J.
/// C. Platt, Advances in Large Margin Classifiers, MIT Press 2000, 61-74). The benchmark of hidden effects fits it and
/// writes calibration.json, which is compiled in.
struct ShippedCalibration {
  Calibration all;
  std::map<std::string, Calibration> without;  ///< by rig: fitted to the cases of all other rigs and tested on this one
};

const ShippedCalibration& shipped_calibration();

/// Throws `nlohmann::json::exception` for a document of another form.
ShippedCalibration read_calibration(const std::string& document);
std::string calibration_json(const ShippedCalibration& calibration, const std::string& source);

/// Sets evidence and, where the verdict is calibrated, the probability.
void tell_probability(Diagnosis& diagnosis, Evidence evidence);

}  // namespace lacuna
