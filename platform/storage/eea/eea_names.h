#pragma once

#include "storage/eea/eea_records.h"

#include <string>

namespace lacuna {

/// How enumerators of the algorithm stand in the database.
inline const char* to_string(EvaluationKind kind) {
  switch (kind) {
    case EvaluationKind::full: return "full";
    case EvaluationKind::abandoned: return "abandoned";
    case EvaluationKind::invalid: return "invalid";
  }
  return "";
}

inline EvaluationKind evaluation_kind_from(const std::string& text) {
  if (text == "full") return EvaluationKind::full;
  return text == "abandoned" ? EvaluationKind::abandoned : EvaluationKind::invalid;
}

/// The name of a trial that carried a test of the run out.
inline std::string name_of_test_trial(RunId run, std::int64_t number) {
  return "run " + std::to_string(run.value) + ", trial " + std::to_string(number);
}

}  // namespace lacuna
