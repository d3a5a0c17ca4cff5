#include "fitting/shooting/refine_all.h"

#include "foundation/parallel.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <mutex>

namespace lacuna {
namespace {

/// How many searches run side by side.
int searches_at_once(const ShootingProblem& problem, std::size_t starts) {
  const std::size_t threads = static_cast<std::size_t>(problem.predictor().workers());
  const std::size_t simulations = std::max<std::size_t>(problem.simulations_at_once(), 1);
  return static_cast<int>(std::clamp<std::size_t>((threads + simulations - 1) / simulations, 1, starts));
}

}  // namespace

std::vector<Candidate> refine_all(ShootingProblem& problem, const std::vector<Eigen::VectorXd>& starts,
                                  const RefinementOptions& options, ProgressMeter& meter, const std::string& what) {
  if (starts.empty()) return {};
  const TrialPredictor& predictor = problem.predictor();
  const int at_once = searches_at_once(problem, starts.size());
  std::vector<std::unique_ptr<TrialPredictor>> simulators;  // the first search has the problem's own
  for (int i = 1; i < at_once; ++i)
    simulators.push_back(std::make_unique<TrialPredictor>(predictor.model(), predictor.trials(),
                                                          Work{predictor.workers() / at_once, predictor.stop()}));

  std::mutex mutex;
  RefinementOptions shared = options;
  shared.progress = [&](int iteration) {
    const std::scoped_lock lock(mutex);
    meter.report(iteration);
  };
  std::vector<Candidate> candidates(starts.size());
  parallel_for(starts.size(), at_once, [&](std::size_t i, int worker) {
    {
      const std::scoped_lock lock(mutex);
      meter.begin_part(fmt::format("{}, {} of {}", what, i + 1, starts.size()));
    }
    ShootingProblem own(problem, worker == 0 ? predictor : *simulators[static_cast<std::size_t>(worker - 1)]);
    candidates[i] = refine(own, starts[i], shared);
    const std::scoped_lock lock(mutex);
    problem.count_in(own);
    meter.end_part();
  });
  return candidates;
}

}  // namespace lacuna
