#pragma once

#include "cases/case_plan.h"
#include "runs/database.h"
#include "runs/records.h"

namespace hidden_effects {

/// Notes the version if it is new, and what the program says of itself.
void keep_version(Database& database, const std::string& version, const std::string& program);

bool has_case(const Database& database, const std::string& version, const std::string& set, int number);

/// Removes those of these cases that ended early, so that they are run again. How many there were.
int forget_failures(Database& database, const std::string& version, const std::vector<CasePlan>& plans);

/// Writes all of a case in one transaction. One that another process was faster with stays as it is.
void keep_case(Database& database, const CaseResult& result);

}  // namespace hidden_effects
