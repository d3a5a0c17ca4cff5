#pragma once

#include "runs/database.h"
#include "runs/records.h"

namespace hidden_effects {

/// Notes the version if it is new, and what the program says of itself.
void keep_version(Database& database, const std::string& version, const std::string& program);

bool has_case(const Database& database, const std::string& version, const std::string& set, int number);

/// Whether the database has the case with a `failure`.
bool ended_early(const Database& database, const std::string& version, const std::string& set, int number);

/// Writes all of a case in one transaction, in the place of one that ended early. One that another process was faster
/// with stays as it is.
void keep_case(Database& database, const CaseResult& result);

}  // namespace hidden_effects
