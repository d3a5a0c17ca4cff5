#pragma once

#include "runs/records.h"

#include <string>
#include <vector>

namespace hidden_effects {

/// Reads what `lacuna diagnose --json` wrote. Everything here throws `std::runtime_error` for a text that is not that.
DiagnosisRecord read_diagnosis(const std::string& json);

/// What `lacuna compare --json` wrote.
struct ReadComparison {
  std::vector<NamedValue> held_out;  ///< RMSE by channel over the held-out trials; NaN where one was not simulated
};
ReadComparison read_comparison(const std::string& json);

/// Names of all effects, from `lacuna plugins list --json`.
std::vector<std::string> read_effects(const std::string& json);

}  // namespace hidden_effects
