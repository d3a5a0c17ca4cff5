#include "data_checks/trial_checks.h"

#include "data_checks/straight_fit.h"
#include "foundation/unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace lacuna {
namespace {

/// Squares that one lag for all trials adds to those of a trial's own lag: where the model explains accelerations down
/// to a few times the noise, and where something else is missing, which may look like a lag.
constexpr double kAddsToNoise = 1.0, kAddsToMore = 10.0;
constexpr double kFewNoises = 4.0;     // squares a row
constexpr double kUnexplained = 0.05;  // of the squared accelerations: with a larger residual a lag means nothing
constexpr double kContradicts = 1.5;   // squares that shared coefficients add, over the residual without sharing
constexpr double kNoticeable = 0.01;   // of the squared accelerations
constexpr double kMoves = 0.1;         // of the RMS velocity

/// A trial compared with all others: the improvement by its own lag.
struct Shift {
  std::size_t place = 0;  ///< among the profiles
  double by = 0.0;        ///< s later than the others
  double added = 0.0;     ///< squares that one lag for all adds
  double share = 0.0;     ///< the same, over the residual of the trial at its own lag
};

double squares_at(const std::vector<const CommandLagProfile*>& profiles, Eigen::Index lag) {
  double squares = 0.0;
  for (const CommandLagProfile* profile : profiles) squares += profile->squares(lag);
  return squares;
}

Shift shift_of(const CommandLags& lags, const std::vector<const CommandLagProfile*>& profiles, std::size_t place) {
  std::vector<const CommandLagProfile*> others = profiles;
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(place));
  const CommandLagProfile& own = *profiles[place];
  const Eigen::Index mine = best_lag({&own}), theirs = best_lag(others), shared = best_lag(profiles);
  const double added = squares_at(profiles, shared) - own.squares(mine) - squares_at(others, theirs);
  return {place, lags.lags(mine) - lags.lags(theirs), added, added / std::max(own.squares(mine), own.rows)};
}

/// Whether only shifted time stamps can cause so large an addition.
bool is_shift(const CommandLags& lags, const std::vector<const CommandLagProfile*>& profiles, const Shift& shift) {
  if (std::abs(shift.by) <= kHeldIntervals * lags.interval) return false;
  // A clock that runs fast or slow is an effect; it shifts longer trials by more.
  if (std::abs(lag_drift(lags, {profiles[shift.place]})) > kSteadyLag * std::abs(shift.by)) return false;
  bool down_to_noise = true;
  for (const CommandLagProfile* profile : profiles) {
    const double left = profile->squares.minCoeff();
    if (left > std::max(kUnexplained * profile->power, kFewNoises * profile->rows)) return false;
    down_to_noise = down_to_noise && left <= kFewNoises * profile->rows;
  }
  return shift.share > (down_to_noise ? kAddsToNoise : kAddsToMore);
}

std::string shifted_sentence(const AccelerationTable& table, const std::vector<const CommandLagProfile*>& profiles,
                             const Shift& shift, bool named) {
  const auto name = [&](std::size_t place) { return table.trials[profiles[place]->trial].name; };
  const std::string reason =
      fmt::format("with one common lag, the squared residual is {:.2g} times as large", 1.0 + shift.share);
  if (!named)
    return fmt::format(
        "the responses of {} and {} to their commands are {:.0f} ms apart ({}): the time stamps of one file are "
        "shifted; correct them or leave that file out",
        name(0), name(1), 1e3 * std::abs(shift.by), reason);
  return fmt::format(
      "{}: relative to its commands the motion comes {:.0f} ms {} than in the other files ({}): its time stamps are "
      "shifted; correct them or leave the file out",
      name(shift.place), 1e3 * std::abs(shift.by), shift.by > 0.0 ? "later" : "earlier", reason);
}

/// The trials whose lag differs from that of all others, one by one: first the one without which the others agree best.
std::set<std::size_t> doubt_lags(const AccelerationTable& table, const CommandLags& lags,
                                 std::vector<DataWarning>& doubts) {
  std::set<std::size_t> shifted;
  std::vector<const CommandLagProfile*> left;
  for (const CommandLagProfile& profile : lags.profiles) left.push_back(&profile);
  const bool named = left.size() > 2;
  while (left.size() >= 2) {
    std::optional<Shift> worst;
    for (std::size_t place = 0; place < left.size(); ++place) {
      const Shift shift = shift_of(lags, left, place);
      if (is_shift(lags, left, shift) && (!worst || shift.added > worst->added)) worst = shift;
    }
    if (!worst) break;
    doubts.push_back({Severity::fault, shifted_sentence(table, left, *worst, named)});
    shifted.insert(left[worst->place]->trial);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(worst->place));
  }
  return shifted;
}

/// The surroundings plus terms for nonlinear springs and dampers, so that trials at different positions do not
/// contradict each other for that reason.
Eigen::MatrixXd wider_surroundings(const ChannelAccelerations& one) {
  const Eigen::MatrixXd straight = surroundings(one);
  const Eigen::ArrayXd q = one.position.array(), v = one.velocity.array();
  Eigen::MatrixXd columns(straight.rows(), straight.cols() + 3);
  columns << straight, (q.square() / one.deviation).matrix(), (q.cube() / one.deviation).matrix(),
      (v * v.abs() / one.deviation).matrix();
  return columns;
}

/// Rows in which the joint moves: dry friction at rest follows no linear law.
std::vector<Eigen::Index> moving_rows(const ChannelAccelerations& one) {
  const Eigen::Index count = one.velocity.size();
  const double usual = std::sqrt(one.velocity.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(count, 1)));
  std::vector<Eigen::Index> rows;
  for (Eigen::Index row = 0; row < count; ++row)
    if (std::abs(one.velocity(row)) > kMoves * usual) rows.push_back(row);
  return rows;
}

/// Columns and values of some trials' rows of one channel, one below the other.
struct StackedRows {
  Eigen::MatrixXd columns;
  Eigen::VectorXd values;
  void add(const ChannelAccelerations& one) {
    const std::vector<Eigen::Index> moving = moving_rows(one);
    const auto more = static_cast<Eigen::Index>(moving.size());
    const Eigen::MatrixXd beside = wider_surroundings(one)(moving, Eigen::all);
    const Eigen::Index before = values.size(), rows = before + more;
    columns.conservativeResize(rows, beside.cols() + one.commanded.cols());
    values.conservativeResize(rows);
    columns.bottomRows(more) << beside, one.commanded(moving, Eigen::all) / one.deviation;
    values.tail(more) = one.measured(moving) / one.deviation;
  }
  double squares() const { return values.size() == 0 ? 0.0 : straight_fit(columns, values).squares; }
};

struct Contradiction {
  std::size_t trial = 0;
  double together = 0.0, apart = 0.0;  ///< squares left with shared coefficients, and with the trial's own
  double rows = 0.0;
  const ChannelAccelerations* channel = nullptr;
  std::vector<std::size_t> others;  ///< trials
};

/// Squares added for a trial by sharing coefficients with the others of `channels`, all of one channel.
Contradiction contradiction_of(const std::vector<const ChannelAccelerations*>& channels, std::size_t which) {
  StackedRows all, others, own;
  std::vector<std::size_t> trials;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    all.add(*channels[i]);
    (i == which ? own : others).add(*channels[i]);
    if (i != which) trials.push_back(channels[i]->trial);
  }
  return {
      channels[which]->trial, all.squares(), others.squares() + own.squares(), static_cast<double>(all.values.size()),
      channels[which],        trials};
}

bool contradicts(const Contradiction& one) {
  const double added = one.together - one.apart;
  return added > kContradicts * std::max(one.apart, one.rows) &&
         added > kNoticeable * (one.channel->measured / one.channel->deviation).squaredNorm();
}

std::string contradiction_sentence(const AccelerationTable& table, const Contradiction& one, bool named) {
  const auto left = [&](double squares) {
    return format_quantity(std::sqrt(squares / one.rows) * one.channel->deviation, one.channel->unit);
  };
  const std::string what = fmt::format(
      "no common inertia, stiffness, damping, friction and offset explain {} in both; the residual acceleration is "
      "{} (RMS) with common values and {} with separate ones",
      one.channel->channel, left(one.together), left(one.apart));
  if (!named)
    return fmt::format("{} and {} contradict each other: {}; leave out the file of another rig or load",
                       table.trials[one.others.front()].name, table.trials[one.trial].name, what);
  return fmt::format("{} contradicts the other files: {}; leave it out if it comes from another rig or load",
                     table.trials[one.trial].name, what);
}

/// One channel's trials, the one that contradicts most first, until the others agree.
void doubt_agreement(const AccelerationTable& table, std::vector<const ChannelAccelerations*> channels,
                     std::vector<DataWarning>& doubts) {
  const std::size_t count = channels.size();
  while (channels.size() >= 2) {
    Contradiction worst;
    std::size_t place = channels.size();
    for (std::size_t i = 0; i < channels.size(); ++i) {
      const Contradiction one = contradiction_of(channels, i);
      if (!contradicts(one) || (place < channels.size() && one.apart >= worst.apart)) continue;
      worst = one;
      place = i;
    }
    if (place == channels.size()) return;
    doubts.push_back({Severity::fault, contradiction_sentence(table, worst, count > 2), true});
    channels.erase(channels.begin() + static_cast<std::ptrdiff_t>(place));
  }
}

}  // namespace

std::vector<DataWarning> trial_checks(const AccelerationTable& table, const CommandLags& lags) {
  std::vector<DataWarning> doubts;
  const std::set<std::size_t> shifted = doubt_lags(table, lags, doubts);
  std::set<std::string> names;
  for (const ChannelAccelerations& one : table.channels) names.insert(one.channel);
  for (const std::string& name : names) {
    std::vector<const ChannelAccelerations*> channels;
    for (const ChannelAccelerations& one : table.channels)
      if (one.channel == name && !shifted.contains(one.trial)) channels.push_back(&one);
    doubt_agreement(table, channels, doubts);
  }
  return doubts;
}

}  // namespace lacuna
