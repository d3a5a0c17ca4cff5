#pragma once

#include "cases/case_plan.h"
#include "runs/database.h"
#include "runs/records.h"

#include <functional>
#include <string>
#include <vector>

namespace hidden_effects {

/// Carries out one case; throws `CaseStopped`.
using RunOne = std::function<CaseResult(const CasePlan&)>;

struct SetProgress {
  int kept = 0;    ///< now
  int failed = 0;  ///< of these: ended early
  int before = 0;  ///< which the database had already
  int left = 0;
  bool stopped = false;
};

/// Runs every case that the database does not have yet for this version, with `again` those that ended early, too,
/// `jobs` at a time, and keeps each when it is done. `told(result, progress)` is called after each, by one thread at a
/// time. When `stop` says so, what is under way is given up and not kept.
SetProgress run_set(Database& database, const std::string& version, const std::vector<CasePlan>& plans, int jobs,
                    bool again, const RunOne& run_one, const std::function<bool()>& stop,
                    const std::function<void(const CaseResult&, const SetProgress&)>& told);

}  // namespace hidden_effects
