#include "data_checks/command_lags.h"

#include "data_checks/straight_fit.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kFarthest = 0.3;    // s
constexpr Eigen::Index kSteps = 60;  // to either side
constexpr double kRowsPerColumn = 4.0;
constexpr double kSlow = 0.05;  // of the RMS velocity, below which the direction of motion counts less

bool all_forces(const RobotSpec& robot) {
  return std::all_of(robot.actuators.begin(), robot.actuators.end(),
                     [](const ActuatorSpec& actuator) { return actuator.kind == ActuatorKind::force; });
}

double interval_of(const Eigen::VectorXd& times) {
  return times.size() < 2 ? 0.0 : (times(times.size() - 1) - times(0)) / static_cast<double>(times.size() - 1);
}

CommandLagProfile profile_of(const AccelerationTable& table, std::size_t trial, const Eigen::VectorXd& lags) {
  CommandLagProfile profile;
  profile.trial = trial;
  profile.squares = profile.early = profile.late = Eigen::VectorXd::Zero(lags.size());
  for (const ChannelAccelerations& channel : table.channels) {
    if (channel.trial != trial) continue;
    const Eigen::MatrixXd beside = surroundings(channel);
    const Eigen::VectorXd measured = channel.measured / channel.deviation;
    Eigen::MatrixXd columns(beside.rows(), beside.cols());
    for (Eigen::Index i = 0; i < lags.size(); ++i) {
      const Eigen::MatrixXd commands = channel.of_commands(table.trials[trial], lags(i)) / channel.deviation;
      columns.resize(beside.rows(), beside.cols() + commands.cols());
      columns << beside, commands;
      profile.squares(i) += straight_fit(columns, measured).squares;
      const Eigen::Index half = channel.size() / 2, rest = channel.size() - half;
      profile.early(i) += straight_fit(columns.topRows(half), measured.head(half)).squares;
      profile.late(i) += straight_fit(columns.bottomRows(rest), measured.tail(rest)).squares;
    }
    profile.power += measured.squaredNorm();
    const Eigen::VectorXd predicted = channel.uncommanded + channel.commanded.rowwise().sum();
    profile.of_model += (measured - predicted / channel.deviation).squaredNorm();
    profile.rows += static_cast<double>(channel.size());
    profile.freedom += static_cast<double>(channel.size() - columns.cols());
  }
  return profile;
}

/// Where the sum of one of the profiles' curves is least; the middle of several such places.
Eigen::Index least(const std::vector<const CommandLagProfile*>& profiles, Eigen::VectorXd CommandLagProfile::*curve) {
  Eigen::VectorXd all = Eigen::VectorXd::Zero((profiles.front()->*curve).size());
  for (const CommandLagProfile* profile : profiles) all += profile->*curve;
  Eigen::Index best = all.size() / 2;
  for (Eigen::Index i = 0; i < all.size(); ++i)
    if (all(i) < all(best)) best = i;
  return best;
}

}  // namespace

Eigen::MatrixXd surroundings(const ChannelAccelerations& channel) {
  const Eigen::VectorXd& v = channel.velocity;
  const double slow = kSlow * std::sqrt(v.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(v.size(), 1)));
  Eigen::MatrixXd columns(channel.size(), 5);
  columns.col(0) = channel.uncommanded;
  columns.col(1).setOnes();
  columns.col(2) = channel.position;
  columns.col(3) = v;
  columns.col(4) = slow > 0.0 ? Eigen::VectorXd((v / slow).array().tanh()) : Eigen::VectorXd::Zero(v.size());
  return columns / channel.deviation;
}

CommandLags command_lags(const DataCheckTask& task, const AccelerationTable& table) {
  CommandLags result;
  result.lags = Eigen::VectorXd::LinSpaced(2 * kSteps + 1, -kFarthest, kFarthest);
  if (!all_forces(task.definition.structure.robot)) return result;
  for (std::size_t trial = 0; trial < table.trials.size(); ++trial) {
    const Trial& one = table.trials[trial];
    if (one.commands.series.times.size() < 2) continue;
    result.interval =
        std::max({result.interval, interval_of(one.commands.series.times), interval_of(one.measured.times)});
    CommandLagProfile profile = profile_of(table, trial, result.lags);
    if (profile.rows >= kRowsPerColumn * (profile.rows - profile.freedom) && profile.rows > 0.0)
      result.profiles.push_back(std::move(profile));
  }
  return result;
}

Eigen::Index best_lag(const std::vector<const CommandLagProfile*>& profiles) {
  return least(profiles, &CommandLagProfile::squares);
}

double lag_drift(const CommandLags& lags, const std::vector<const CommandLagProfile*>& profiles) {
  return lags.lags(least(profiles, &CommandLagProfile::late)) - lags.lags(least(profiles, &CommandLagProfile::early));
}

}  // namespace lacuna
