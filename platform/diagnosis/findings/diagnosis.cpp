#include "diagnosis/findings/diagnosis.h"

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

std::string_view to_string(FigureUnit unit) {
  switch (unit) {
    case FigureUnit::percent: return "percent";
    case FigureUnit::nats: return "nats";
    case FigureUnit::chance: return "chance";
    case FigureUnit::times_floor: return "times_floor";
  }
  return "";
}

std::string_view to_string(DiagnosisMethod method) {
  return method == DiagnosisMethod::likelihood ? "likelihood" : "horizon";
}

std::optional<DiagnosisMethod> method_of(const Diagnosis& diagnosis) {
  if (!diagnosis.horizons.empty()) return DiagnosisMethod::horizon;
  if (!diagnosis.base.empty()) return DiagnosisMethod::likelihood;
  return std::nullopt;
}

double gained(const std::optional<Gain>& gain) { return gain ? std::max(0.0, gain->value) : 0.0; }

}  // namespace lacuna
