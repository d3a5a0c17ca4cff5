#pragma once

#include "cases/case_plan.h"
#include "dirty/dirty_case.h"
#include "runs/records.h"

#include <string>
#include <vector>

namespace hidden_effects {

/// The cases of a dirty set as the other commands select and count them: the family stands for group and rig. Throws
/// `std::invalid_argument` for another set.
std::vector<CasePlan> dirty_case_plans(const std::string& set);

/// The plan behind one of them.
dirty::DirtyPlan dirty_plan_of(const CasePlan& plan);

/// What is known of a case before it is made, and the whole: the main effects are the hidden laws.
CaseRecord about_dirty_plan(const CasePlan& plan, const std::string& version);
CaseRecord about_dirty_case(const dirty::DirtyCase& made, const CasePlan& plan, const std::string& version);

/// Everything that is not as its owner believes.
std::vector<DirtyEffectRecord> dirty_effects(const dirty::DirtyCase& made);

/// Of `make --truth`, for reading.
std::string dirty_truth_json(const dirty::DirtyCase& made);

}  // namespace hidden_effects
