#pragma once

#include "cases/case_plan.h"

namespace hidden_effects {

/// The cases with contacts of a set, numbered from `first` on: 60 for reporting, 6 for tuning, as many of each rig; a
/// fifth of them hides nothing.
std::vector<CasePlan> plan_contact_cases(const std::string& set, int first);

/// All cases of a set: those of `plan_cases`, then those with contacts. Throws `std::invalid_argument`.
std::vector<CasePlan> plan_all_cases(const std::string& set);

}  // namespace hidden_effects
