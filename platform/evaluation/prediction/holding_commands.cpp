#include "evaluation/prediction/holding_commands.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kOneStep = 1e-6;  ///< s, less than a step: the simulation takes one
constexpr double kAWhile = 0.02;   ///< s: time in which a rotor behind a spring, which holds for a step, starts to move
constexpr double kStill = 1e-9;    ///< rad/s or m/s
constexpr double kHeld = 1e-6;     ///< of the velocity that the robot reaches without any command
constexpr double kStillHeld = 0.01;  ///< the same after a longer time
constexpr int kMostIterations = 4;   ///< friction and limits make the problem nonlinear

/// Velocities after a time under constant commands.
class FromRest {
 public:
  FromRest(const CompiledModel& model, std::span<const double> values, const std::vector<Channel>& channels,
           const std::vector<double>& positions, std::string setup, Workspace& workspace)
      : model_(model), values_(values), setup_(std::move(setup)), workspace_(workspace) {
    options_.start.positions = positions;
    options_.start.velocities.assign(positions.size(), 0.0);
    options_.save_final_state = true;
    commands_.series.channels = channels;
    commands_.series.times = Eigen::VectorXd::Zero(1);
    for (const StateSection& section : model.state_layout())
      if (section.name == "velocities") velocities_ = section;
  }

  bool velocities(const Eigen::VectorXd& commands, Eigen::VectorXd& after, double time = kOneStep) {
    commands_.series.samples = commands.transpose();
    options_.end_time = time;
    model_.simulate(values_, Test{commands_, time, {}, setup_}, options_, workspace_, result_);
    if (result_.ending != Ending::completed) return false;
    after = Eigen::Map<const Eigen::VectorXd>(result_.final_state.values.data() + velocities_.offset,
                                              static_cast<Eigen::Index>(velocities_.size));
    return after.allFinite();
  }

 private:
  const CompiledModel& model_;
  std::span<const double> values_;
  std::string setup_;
  Workspace& workspace_;
  SimulationOptions options_;
  CommandSeries commands_;
  SimulationResult result_;
  StateSection velocities_;
};

/// Derivatives of the velocities by the unknown commands.
bool slopes(FromRest& from_rest, const Eigen::VectorXd& commands, const std::vector<Eigen::Index>& sought,
            const Eigen::VectorXd& velocities, Eigen::MatrixXd& slopes) {
  slopes.resize(velocities.size(), static_cast<Eigen::Index>(sought.size()));
  Eigen::VectorXd moved;
  for (std::size_t j = 0; j < sought.size(); ++j) {
    Eigen::VectorXd at = commands;
    const double change = std::max(1.0, std::abs(at(sought[j])));
    at(sought[j]) += change;
    if (!from_rest.velocities(at, moved)) return false;
    slopes.col(static_cast<Eigen::Index>(j)) = (moved - velocities) / change;
  }
  return true;
}

}  // namespace

std::optional<std::vector<double>> holding_commands(const CompiledModel& model, std::span<const double> values,
                                                    const std::vector<Channel>& channels, std::vector<double> known,
                                                    const std::vector<double>& positions, const std::string& setup,
                                                    Workspace& workspace) {
  std::vector<Eigen::Index> sought;
  Eigen::VectorXd commands(static_cast<Eigen::Index>(known.size()));
  for (Eigen::Index c = 0; c < commands.size(); ++c) {
    const double value = known[static_cast<std::size_t>(c)];
    if (std::isnan(value)) sought.push_back(c);
    commands(c) = std::isnan(value) ? 0.0 : value;
  }
  FromRest from_rest(model, values, channels, positions, setup, workspace);
  const Eigen::VectorXd without = commands;
  Eigen::VectorXd velocities;
  if (!from_rest.velocities(commands, velocities)) return std::nullopt;
  if (velocities.norm() <= kStill) return std::vector<double>(commands.begin(), commands.end());
  if (sought.empty()) return std::nullopt;
  const double enough = kHeld * velocities.norm();
  Eigen::MatrixXd by_command;
  for (int i = 0; i < kMostIterations && velocities.norm() > enough; ++i) {
    if (!slopes(from_rest, commands, sought, velocities, by_command)) return std::nullopt;
    const Eigen::VectorXd change = by_command.completeOrthogonalDecomposition().solve(-velocities);
    for (std::size_t j = 0; j < sought.size(); ++j) commands(sought[j]) += change(static_cast<Eigen::Index>(j));
    if (!from_rest.velocities(commands, velocities)) return std::nullopt;
  }
  Eigen::VectorXd unheld;
  if (velocities.norm() > enough || !from_rest.velocities(without, unheld, kAWhile) ||
      !from_rest.velocities(commands, velocities, kAWhile) || velocities.norm() > kStillHeld * unheld.norm())
    return std::nullopt;
  return std::vector<double>(commands.begin(), commands.end());
}

}  // namespace lacuna
