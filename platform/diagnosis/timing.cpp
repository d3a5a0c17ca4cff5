#include "diagnosis/timing.h"

#include <algorithm>

namespace lacuna {
namespace {

double sample_interval(const Trial& trial) {
  const Eigen::VectorXd& times = trial.commands.series.times;
  return times.size() < 2 ? 0.0 : (times(times.size() - 1) - times(0)) / static_cast<double>(times.size() - 1);
}

bool residuals_of(const CompiledModel& model, const ModelDefinition& definition, const BaseSolution& base,
                  const std::vector<Trial>& trials, int threads, std::vector<Eigen::VectorXd>& residuals) {
  const TrialPredictor predictor(model, trials, threads);
  const ParameterSpace space(definition.free);
  ShootingProblem problem(predictor, space, base.segments, base.noise);
  return problem.residuals({space.to_coordinates(base.values), base.states}, residuals);
}

}  // namespace

double longest_sample_interval(const std::vector<Trial>& trials) {
  double longest = 0.0;
  for (const Trial& trial : trials) longest = std::max(longest, sample_interval(trial));
  return longest;
}

std::vector<Eigen::MatrixXd> timing_columns(const CompiledModel& model, const ModelDefinition& definition,
                                            const BaseSolution& base, const RowBins& bins, int threads, double shift) {
  std::vector<Trial> late = base.trials;
  for (Trial& trial : late) trial.commands.series.times.array() += shift * sample_interval(trial);
  std::vector<Eigen::VectorXd> now, later;
  if (longest_sample_interval(base.trials) == 0.0 ||
      !residuals_of(model, definition, base, base.trials, threads, now) ||
      !residuals_of(model, definition, base, late, threads, later))
    return {};
  std::vector<Eigen::MatrixXd> columns;
  for (std::size_t k = 0; k < now.size(); ++k) columns.push_back(bins.means(k, (later[k] - now[k]) / shift));
  return columns;
}

}  // namespace lacuna
