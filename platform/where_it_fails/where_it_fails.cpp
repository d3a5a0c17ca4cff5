#include "where_it_fails/where_it_fails.h"

#include "where_it_fails/residual_view.h"

#include <utility>

namespace lacuna {
namespace {

std::vector<ChannelWhiteness> whiteness_of(const Comparison& comparison, const std::vector<Channel>& channels) {
  std::vector<ChannelWhiteness> all;
  for (const Channel& channel : channels) {
    std::vector<Eigen::VectorXd> residuals;
    double duration = 0.0, steps = 0.0;
    for (const TrialComparison& trial : comparison.trials)
      for (std::size_t c = 0; c < trial.channels.size(); ++c) {
        if (trial.held_out || !trial.valid || trial.channels[c].channel != channel.name) continue;
        const Eigen::Index rows = trial.residuals.rows() - trial.first_scored;
        if (rows < 2) continue;
        residuals.emplace_back(trial.residuals.col(static_cast<Eigen::Index>(c)).tail(rows));
        duration += trial.times(trial.times.size() - 1) - trial.times(trial.first_scored);
        steps += static_cast<double>(rows - 1);
      }
    if (!residuals.empty()) all.push_back({channel.name, autocorrelation(residuals, duration / steps)});
  }
  return all;
}

}  // namespace

WhereItFails where_it_fails(const FeatureTask& task) {
  WhereItFails where;
  where.table = state_features(task);
  if (where.table.trial.empty()) return where;
  where.whiteness = whiteness_of(task.comparison, channels_of(task.comparison));
  const RobotSpec& robot = task.definition.structure.robot;
  where.views.push_back(free_run_view(robot, task.comparison, where.table, task.work));
  task.work.stop.throw_if_due();
  ResidualView accelerations = acceleration_view(robot, task.comparison, where.table, task.work);
  if (!accelerations.channels.empty()) where.views.push_back(std::move(accelerations));
  where.findings = findings_of(task.comparison, where.views);
  return where;
}

}  // namespace lacuna
