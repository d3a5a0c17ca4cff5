#pragma once

#include "storage/eea/eea_records.h"

#include <string>

namespace lacuna {

/// How enumerators of the algorithm stand in the database.
inline const char* to_string(ScoreKind kind) {
  switch (kind) {
    case ScoreKind::full: return "full";
    case ScoreKind::abandoned: return "abandoned";
    case ScoreKind::invalid: return "invalid";
  }
  return "";
}

inline ScoreKind score_kind_from(const std::string& text) {
  if (text == "full") return ScoreKind::full;
  return text == "abandoned" ? ScoreKind::abandoned : ScoreKind::invalid;
}

/// The name of a trial that carried a test of the run out.
inline std::string name_of_test_trial(RunId run, std::int64_t number) {
  return "run " + std::to_string(run.value) + ", trial " + std::to_string(number);
}

}  // namespace lacuna
