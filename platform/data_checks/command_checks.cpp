#include "data_checks/command_checks.h"

#include "foundation/statistics.h"
#include "data_checks/stacked_accelerations.h"
#include "data_checks/straight_fit.h"
#include "foundation/address.h"
#include "foundation/unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace lacuna {
namespace {

constexpr double kBeyondEffects = 20.0;    // larger than any gain that a rig may have beyond its model
constexpr double kNamed = 2.5;             // range around a factor of units; masses may be wrong by as much
constexpr double kExplained = 0.5;         // of the squares: the least that a response to a command explains
constexpr double kExplainedAgainst = 0.2;  // of the squares, for a response against the command, which no effect causes
constexpr double kSure = 5.0;              // deviations
constexpr double kLively = 10.0;           // times the noise: acceleration expected from a command
constexpr double kNothing = 0.05;          // of the expected response
constexpr double kWorseNow = 2.0;          // squares left at one lag over those at another
constexpr Eigen::Index kWithoutFriction = 3;  // columns of the surroundings before those of velocity (command_lags.h)

/// Possible causes of a motion that is `times` too large for its commands.
std::string unit_guess(double times, const std::string& unit) {
  const bool angle = unit.starts_with("rad");
  const double size = std::max(times, 1.0 / times);
  const auto near = [&](double factor) { return size < kNamed * factor && size > factor / kNamed; };
  constexpr double kDegree = 180.0 / std::numbers::pi;
  if (angle && near(kDegree))
    return times > 1.0 ? ", as if degrees were read as radians (57.3)"
                       : ", as if an angle in radians were read as degrees (1/57.3)";
  if (near(1000.0))
    return times > 1.0 ? ", as if a reading in thousandths, or a command in thousands, were read without its prefix"
                       : ", as if a command in thousandths (mN*m) were read without its prefix, or a reading in whole "
                         "units as thousandths";
  return ", as if a unit or a gear ratio were missing";
}

/// A command that moves its joint less than the model predicts.
struct Unfollowed {
  std::string channel, actuator, should;
  double percent = 0.0;
};

/// Whether the command follows from the motion of this joint: from its acceleration, the model's motion without
/// commands and, with all surroundings, friction. Then it is this joint's command, and the part that accelerates
/// nothing is lost in friction, or in a rotor that the model lacks.
bool is_explained_by_motion(const StackedAccelerations& data, const Eigen::VectorXd& command,
                            Eigen::Index surroundings) {
  Eigen::MatrixXd motion(data.beside.rows(), surroundings + 1);
  motion << data.measured, data.beside.leftCols(surroundings);
  const Eigen::VectorXd mean = Eigen::VectorXd::Constant(command.size(), command.mean());
  const double whole = (command - mean).squaredNorm();
  return whole > 0.0 && straight_fit(motion, command).squares < (1.0 - kExplained) * whole;
}

/// Whether friction takes most of the command. A command in a wrong unit follows from the motion without friction.
bool is_lost_in_friction(const StackedAccelerations& data, const Eigen::VectorXd& command) {
  return is_explained_by_motion(data, command, data.beside.cols()) &&
         !is_explained_by_motion(data, command, kWithoutFriction);
}

void doubt_response(const StackedAccelerations& data, Eigen::Index u, const std::string& actuator,
                    std::vector<DataWarning>& doubts, std::vector<Unfollowed>& unfollowed) {
  const Eigen::VectorXd own = data.commanded.col(u);
  Eigen::MatrixXd all(data.beside.rows(), data.beside.cols() + data.commanded.cols());
  all << data.commanded, data.beside;
  const StraightFit with_it = straight_fit(all, data.measured);
  Eigen::MatrixXd less = all;
  less.col(u).setZero();
  const double without_it = straight_fit(less, data.measured).squares;
  const double times = with_it.coefficients(u), deviation = with_it.deviations(u);
  const double explained = 1.0 - with_it.squares / std::max(without_it, 1e-300);
  const bool sure = std::abs(times) > kSure * deviation, responds = sure && explained >= kExplained;
  if (sure && times < 0.0 && explained >= kExplainedAgainst) {
    doubts.push_back(
        {Severity::fault,
         fmt::format(
             "{} accelerates against the command {} ({:.3g} times what the model predicts): the sign of a column or of "
             "the joint's axis is wrong, or the command column is a measurement, which lags the motion",
             data.channel, actuator, times),
         true});
  } else if (responds &&
             (times > kBeyondEffects || (times < 1.0 / kBeyondEffects && !is_lost_in_friction(data, own)))) {
    doubts.push_back(
        {Severity::fault, fmt::format("{} accelerates {:.3g} times as much by the command {} as the model predicts{}; "
                                      "check the units of both columns and the model's inertia",
                                      data.channel, times, actuator, unit_guess(times, data.unit))});
  } else if (root_mean_square(own) > kLively && std::abs(times) + kSure * deviation < kNothing &&
             !is_explained_by_motion(data, own, data.beside.cols())) {
    unfollowed.push_back({data.channel, actuator, format_quantity(root_mean_square(own) * data.deviation, data.unit),
                          100.0 * std::abs(times)});
  }
}

/// One sentence about all channels that do not follow their commands.
void doubt_unfollowed(const std::vector<Unfollowed>& unfollowed, std::vector<DataWarning>& doubts) {
  if (unfollowed.empty()) return;
  const Unfollowed& first = unfollowed.front();
  std::string text = fmt::format(
      "{} does not follow the command {}: of the expected acceleration, {} (RMS), the file shows {:.1f} %, and "
      "friction does not explain the difference",
      first.channel, first.actuator, first.should, first.percent);
  for (std::size_t i = 1; i < unfollowed.size(); ++i)
    text += fmt::format("{}{} by {} ({:.1f} %)", i == 1 ? "; nor does " : ", ", unfollowed[i].channel,
                        unfollowed[i].actuator, unfollowed[i].percent);
  doubts.push_back(
      {Severity::fault, text + "; check that each column is the command of its joint and has the right unit", true});
}

/// Whether the command of an actuator should show in a channel directly: in a joint with its own actuators only theirs
/// do. The influence through the links is small beside it and follows from the model's inertias.
bool drives(const RobotSpec& robot, const ActuatorSpec& actuator, const std::string& channel) {
  std::string joint;
  for (const SensorSpec& sensor : robot.sensors)
    for (const Channel& one : sensor_channels(robot, sensor))
      if (one.name == channel) joint = sensor.element;
  const bool has_own =
      std::ranges::any_of(robot.actuators, [&](const ActuatorSpec& other) { return other.joint == joint; });
  return !has_own || actuator.joint == joint;
}

/// Over all trials together; a lag of one trial alone is another check. The residual of the model with the stamped
/// commands counts, too: the model may have effects for which a lag of the commands stands in.
void doubt_order(const CommandLags& lags, std::vector<DataWarning>& doubts) {
  std::vector<const CommandLagProfile*> profiles;
  for (const CommandLagProfile& profile : lags.profiles) profiles.push_back(&profile);
  if (profiles.empty()) return;
  const Eigen::Index best = best_lag(profiles), now = lags.lags.size() / 2;
  if (lags.lags(best) > -kHeldIntervals * lags.interval) return;
  if (std::abs(lag_drift(lags, profiles)) > kSteadyLag * std::abs(lags.lags(best))) return;  // a clock that gains
  double at_best = 0.0, at_now = 0.0, of_model = 0.0;
  for (const CommandLagProfile* profile : profiles) {
    at_best += profile->squares(best);
    at_now += profile->squares(now);
    of_model += profile->of_model;
  }
  at_now = std::min(at_now, of_model);
  if (at_now < kWorseNow * at_best) return;
  doubts.push_back(
      {Severity::fault,
       fmt::format("the motion comes {:.0f} ms before its commands ({:.2g} times less remains unexplained with the "
                   "times corrected); the command column is a measurement, or its time stamps are late",
                   -1e3 * lags.lags(best), at_now / at_best)});
}

}  // namespace

std::vector<DataWarning> command_checks(const DataCheckTask& task, const AccelerationTable& table,
                                        const CommandLags& lags) {
  std::vector<DataWarning> doubts;
  const RobotSpec& robot = task.definition.structure.robot;
  std::vector<Unfollowed> unfollowed;
  for (const StackedAccelerations& data : stacked(table))
    for (std::size_t u = 0; u < robot.actuators.size(); ++u)
      if (data.commanded.col(static_cast<Eigen::Index>(u)).squaredNorm() > 0.0 &&
          drives(robot, robot.actuators[u], data.channel))
        doubt_response(data, static_cast<Eigen::Index>(u), robot.actuators[u].name, doubts, unfollowed);
  doubt_unfollowed(unfollowed, doubts);
  doubt_order(lags, doubts);
  return doubts;
}

}  // namespace lacuna
