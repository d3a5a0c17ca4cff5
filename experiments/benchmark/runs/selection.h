#pragma once

#include "cases/case_plan.h"

#include <string>
#include <vector>

namespace hidden_effects {

/// All cases of a set, a dirty one or another. Throws `std::invalid_argument`.
std::vector<CasePlan> plans_of_set(const std::string& set);

/// Which cases of a set are meant: "12", "0-39" (numbers) or all, of these the K-th of N parts ("2/8", by turns).
/// Empty texts mean all. Throws `std::invalid_argument` with a sentence.
std::vector<CasePlan> selected(std::vector<CasePlan> plans, const std::string& cases, const std::string& part);

}  // namespace hidden_effects
