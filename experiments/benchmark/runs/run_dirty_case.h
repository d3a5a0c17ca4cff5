#pragma once

#include "cases/case_plan.h"
#include "runs/records.h"
#include "runs/user_session.h"

#include <filesystem>
#include <string>

namespace hidden_effects {

/// Makes a dirty case in `work`/its name, diagnoses it once, and removes the folder unless it is to be kept. A case
/// that cannot be made is a result with its reason, too. Throws `CaseStopped`.
CaseResult run_dirty_case(const CasePlan& plan, const std::string& version, const std::filesystem::path& work,
                          bool keep, const ProgramSettings& settings);

}  // namespace hidden_effects
