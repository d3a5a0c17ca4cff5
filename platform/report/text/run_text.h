#pragma once

#include "storage/eea/eea_store.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace lacuna {

/// A row a pass: error of the best model, the objective metric's group figures, the fitness of the test it chose as
/// predicted and as the target showed it, and how much was simulated.
std::string passes_text(const std::vector<PassRow>& passes, const std::vector<TargetTrialRow>& trials);

/// A row a run, for `lacuna runs`.
std::string runs_text(const std::vector<EeaRunListing>& runs);

nlohmann::ordered_json pass_json(const PassRow& pass);
nlohmann::ordered_json runs_json(const std::vector<EeaRunListing>& runs);

}  // namespace lacuna
