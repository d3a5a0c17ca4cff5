#include "runs/run_set.h"

#include "foundation/parallel.h"
#include "runs/case_store.h"
#include "runs/user_session.h"

#include <atomic>
#include <mutex>

namespace hidden_effects {
namespace {

std::vector<CasePlan> missing(const Database& database, const std::string& version, const std::vector<CasePlan>& plans,
                              bool again) {
  std::vector<CasePlan> left;
  for (const CasePlan& plan : plans)
    if (!has_case(database, version, plan.set, plan.number) ||
        (again && ended_early(database, version, plan.set, plan.number)))
      left.push_back(plan);
  return left;
}

}  // namespace

SetProgress run_set(Database& database, const std::string& version, const std::vector<CasePlan>& plans, int jobs,
                    bool again, const RunOne& run_one, const std::function<bool()>& stop,
                    const std::function<void(const CaseResult&, const SetProgress&)>& told) {
  const std::vector<CasePlan> left = missing(database, version, plans, again);
  SetProgress progress{0, 0, static_cast<int>(plans.size() - left.size()), static_cast<int>(left.size()), false};
  std::mutex one_writer;
  std::atomic<bool> broken = false;  // what cannot be kept need not be computed
  const auto keep = [&](const CaseResult& result) {
    const std::lock_guard lock(one_writer);
    keep_case(database, result);
    ++progress.kept;
    progress.failed += !result.failure.empty();
    --progress.left;
    told(result, progress);
  };
  lacuna::parallel_for(left.size(), jobs, [&](std::size_t index, int) {
    if (stop() || broken) return;
    try {
      keep(run_one(left[index]));
    } catch (const CaseStopped&) {
      // begun again by the next call
    } catch (...) {
      broken = true;
      throw;
    }
  });
  progress.stopped = stop() && progress.left > 0;
  return progress;
}

}  // namespace hidden_effects
