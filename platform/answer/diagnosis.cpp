#include "answer/diagnosis.h"

#include <algorithm>

namespace lacuna {

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::nothing_missing: return "nothing_missing";
    case Verdict::effect_found: return "effect_found";
    case Verdict::not_in_library: return "not_in_library";
    case Verdict::cannot_tell: return "cannot_tell";
  }
  return "";
}

std::string_view to_string(DiagnosisMethod method) {
  switch (method) {
    case DiagnosisMethod::prediction: return "prediction";
    case DiagnosisMethod::horizon: return "horizon";
    case DiagnosisMethod::likelihood: return "likelihood";
  }
  return "";
}

std::optional<DiagnosisMethod> read_method(std::string_view text) {
  for (const auto method : {DiagnosisMethod::prediction, DiagnosisMethod::horizon, DiagnosisMethod::likelihood})
    if (to_string(method) == text) return method;
  return std::nullopt;
}

double gained(const std::optional<Gain>& gain) { return gain ? std::max(0.0, gain->value) : 0.0; }

}  // namespace lacuna
