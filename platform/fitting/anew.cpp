#include "fitting/anew.h"

#include "fitting/shooting/held_values.h"
#include "fitting/shooting/refine_all.h"
#include "fitting/stage_drift.h"
#include "fitting/shooting/start_points.h"
#include "foundation/address.h"

namespace lacuna {
namespace {

constexpr double kLoose =
    1e-3;  ///< relative decrease of the cost that ends a search which decides where another one begins

/// Whether an effect has a start value from earlier knowledge; 0 is none.
bool is_known(const FreeValue& free) { return is_of_effect(free.address) && free.start != 0.0; }

RefinementOptions search(const AnewTask& task, double precision) {
  return {task.loss, task.fit.options.max_iterations, precision};
}

int try_points(const AnewTask& task, const std::vector<Eigen::VectorXd>& points, std::vector<Candidate>& candidates) {
  const std::string stage = task.stage + ", anew";
  task.meter.add_parts(2 * static_cast<int>(points.size()));
  std::vector<Candidate> others = refine_all(task.problem, points, search(task, kCoarse), task.meter, stage);
  const double best = candidates.front().objective;
  std::erase_if(others, [&](const Candidate& other) { return !other.valid || other.objective >= best; });
  others = refine_all(task.problem, starts_of(others), search(task, kFine), task.meter, stage);
  candidates.insert(candidates.end(), others.begin(), others.end());
  return static_cast<int>(points.size());
}

/// The best values of all else beside the known ones.
Eigen::VectorXd beside_known(const AnewTask& task, const Candidate& best, const Eigen::VectorXd& known) {
  const std::vector<FreeValue>& free = task.fit.definition.free;
  std::vector<Eigen::Index> others;
  for (Eigen::Index j = 0; j < task.space.size(); ++j)
    if (!is_known(free[static_cast<std::size_t>(j)])) others.push_back(j);
  if (others.empty()) return known;
  task.meter.add_parts(1);
  task.meter.begin_part(task.stage + ", with the known starts of effects");
  task.problem.set_scales(best.scales);
  LeastSquaresOptions options;
  options.loss = task.loss;
  options.max_iterations = task.fit.options.max_iterations;
  options.tolerance = kLoose;
  options.progress = [&](int iteration) { task.meter.report(iteration); };
  Eigen::VectorXd beside = fit_beside_held(task.problem, known, others, options);
  task.meter.end_part();
  return beside;
}

}  // namespace

int try_all_starts(const AnewTask& task, std::vector<Candidate>& candidates) {
  return try_points(
      task, start_points(task.problem, task.space, task.fit.definition.free, task.fit.options.starts, task.fit.seed),
      candidates);
}

int try_known_starts(const AnewTask& task, std::vector<Candidate>& candidates) {
  const std::vector<FreeValue>& free = task.fit.definition.free;
  const std::vector<double> found = task.space.to_values(candidates.front().values);
  std::vector<double> known = found;
  for (std::size_t i = 0; i < known.size(); ++i)
    if (is_known(free[i])) known[i] = free[i].start;
  if (!moved(known, found)) return 0;
  return try_points(task, {beside_known(task, candidates.front(), task.space.to_coordinates(known))}, candidates);
}

}  // namespace lacuna
