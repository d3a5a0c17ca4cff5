#include "app/workspace/newest_setting.h"

#include "app/workspace/run_inputs.h"

#include <map>
#include <utility>

namespace lacuna {

std::vector<EeaRunListing> newest_setting(const Database& database, const std::vector<EeaRunListing>& runs) {
  const StoredRun newest = stored_run(database, runs.back().run);
  std::map<int, EeaRunListing> replicates;
  for (const EeaRunListing& run : runs)
    if (run.experiment == runs.back().experiment && same_setting(stored_run(database, run.run), newest))
      replicates.insert_or_assign(run.replicate, run);
  std::vector<EeaRunListing> drawn;
  for (auto& [number, run] : replicates) drawn.push_back(std::move(run));
  return drawn;
}

}  // namespace lacuna
