#pragma once

#include "cases/make_case.h"
#include "runs/records.h"

#include <string>
#include <vector>

namespace hidden_effects {

/// What is known of any case before it is made: no parameters, no measured strength.
CaseRecord about_plan(const CasePlan& plan, const std::string& version);

/// The whole of a planar one.
CaseRecord about_case(const MadeCase& made, const std::string& version);

/// The true values of what the case's user frees.
std::vector<NamedValue> true_free_values(const MadeCase& made);

/// Of `make --truth`, for reading.
std::string truth_json(const CasePlan& plan, const CaseRecord& about, const std::vector<NamedValue>& free_values);

}  // namespace hidden_effects
