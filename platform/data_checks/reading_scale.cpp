#include "data_checks/reading_scale.h"

#include "data_checks/channel_checks.h"
#include "data_checks/command_lags.h"
#include "data_checks/scaled_trials.h"
#include "data_checks/stacked_accelerations.h"
#include "data_checks/straight_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace lacuna {
namespace {

constexpr double kLawFails =
    3.0;  ///< squares that a linear law leaves, over those of noise and over those that the factor leaves
constexpr double kByTheModel = 0.05;   ///< of all squares: the most that the model as written may leave with the factor
constexpr double kUnlikeOthers = 3.0;  ///< squares left with any other factor, over those left with this one
constexpr double kNeighbour = 1.1;     ///< factors this much larger and smaller must be worse
constexpr double kSameFactor = 0.2;    ///< distance of two factors in logarithm
constexpr double kFewestScaledRows = 20.0;
constexpr double kMostOfTheRows = 0.5;  ///< of the rows without a factor; with fewer, predictions failed
constexpr Eigen::Index kFewestOfAFall = 5;
constexpr std::size_t kMostScaled =
    5000;                               ///< over all trials, actuators and searches: a check should take about a second
constexpr std::size_t kMostJoints = 3;  ///< more take longer
constexpr double kSteadyFall = 0.1;     ///< standard deviation of a fall's acceleration over its mean
constexpr double kNamedFall = 0.1;      ///< tolerance of a factor of length units, which are far apart
constexpr double kExplainedFall = 0.05;  ///< of the squares, which a fall may leave

constexpr double kTurn = 2.0 * std::numbers::pi;

struct NamedFactor {
  double factor;
  std::string cause;
};

const std::vector<NamedFactor>& angle_factors() {
  static const std::vector<NamedFactor> kFactors = [] {
    std::vector<NamedFactor> factors = {{180.0 / std::numbers::pi, "as if degrees were read as radians"},
                                        {std::numbers::pi / 180.0, "as if radians were read as degrees"},
                                        {1.0 / kTurn, "as if turns were read as radians"},
                                        {kTurn, "as if radians were read as turns"},
                                        {360.0, "as if degrees were read as turns"},
                                        {1.0 / 360.0, "as if turns were read as degrees"}};
    for (const int count : {2, 3, 4, 5, 6, 8, 10, 20, 50, 100}) {
      factors.push_back(
          {1.0 / count,
           fmt::format("as if the counts per turn were {0} times too large, or a gear of 1:{0} were not included",
                       count)});
      factors.push_back(
          {1.0 * count,
           fmt::format("as if the counts per turn were {0} times too small, or a gear of {0}:1 were not included",
                       count)});
    }
    return factors;
  }();
  return kFactors;
}

const std::vector<NamedFactor>& fall_factors() {
  static const std::vector<NamedFactor> kFactors = {{1.0 / 0.3048, "as if feet were read as metres"},
                                                    {1.0 / 0.0254, "as if inches were read as metres"},
                                                    {100.0, "as if centimetres were read as metres"},
                                                    {1000.0, "as if millimetres were read as metres"}};
  return kFactors;
}

/// Unexplained squares of the measured accelerations, rows over their noise.
struct Squares {
  double all = 0.0, rows = 0.0;
  double straight = 0.0;  ///< with any inertia, stiffness, damping, friction, offset and gain
  double written = 0.0;   ///< with the model as written and any damping, friction and offset
};

/// Model as written plus losses that it may lack.
double written_squares(const ChannelAccelerations& one) {
  const Eigen::MatrixXd beside = surroundings(one);
  Eigen::MatrixXd losses(beside.rows(), 3);
  losses << beside.col(1), beside.col(3), beside.col(4);
  const Eigen::VectorXd predicted = one.uncommanded + one.commanded.rowwise().sum();
  return straight_fit(losses, (one.measured - predicted) / one.deviation).squares;
}

Eigen::Index samples_for(const RobotSpec& robot) {
  const std::size_t searches = std::max<std::size_t>(joint_readings(robot).size(), 1);
  return static_cast<Eigen::Index>(kMostScaled / (searches * std::max<std::size_t>(robot.actuators.size(), 1)));
}

class ScaleSearch {
 public:
  explicit ScaleSearch(const DataCheckTask& task)
      : task_(task),
        trials_(beginnings(task.trials, samples_for(task.definition.structure.robot))),
        values_(task.definition.start_values()) {}

  Squares squares(const std::vector<std::string>& channels, double factor) const {
    const std::vector<Trial> scaled = divided(trials_, channels, factor);
    const DataCheckTask task{task_.definition, task_.model, scaled, values_, false, task_.stop};
    const AccelerationTable table = acceleration_table(task, sensor_noise(task_.definition.structure.robot, scaled));
    Squares sum;
    for (const StackedAccelerations& one : stacked(table)) {
      Eigen::MatrixXd columns(one.beside.rows(), one.beside.cols() + one.commanded.cols());
      columns << one.beside, one.commanded;
      sum.straight += straight_fit(columns, one.measured).squares;
      sum.all += one.measured.squaredNorm();
      sum.rows += static_cast<double>(one.measured.size());
    }
    for (const ChannelAccelerations& one : table.channels) sum.written += written_squares(one);
    return sum;
  }

  /// The factor of these channels with which the model as written explains what no linear law explains without a
  /// factor.
  std::optional<ReadingScale> of_angles(const std::vector<std::string>& channels) const {
    const Squares now = squares(channels, 1.0);
    if (now.rows < kFewestScaledRows || now.straight < kLawFails * now.rows) return std::nullopt;
    std::vector<Tried> tried{{1.0, now}};
    const NamedFactor* best = nullptr;
    Squares least = now;
    for (const NamedFactor& candidate : angle_factors()) {
      const Squares one = squares(channels, candidate.factor);
      if (one.rows < kMostOfTheRows * now.rows) continue;
      tried.push_back({candidate.factor, one});
      if (one.written >= least.written) continue;
      least = one;
      best = &candidate;
    }
    if (!best || least.written > kByTheModel * least.all || now.straight < kLawFails * least.straight ||
        !stands_alone(tried, best->factor, least.written) || !is_lowest(channels, best->factor, least.written))
      return std::nullopt;
    return ReadingScale{channels, "rad", best->factor, best->cause, now.straight / now.all, least.written / least.all};
  }

  /// The factor by which an undriven fall is too fast.
  std::optional<ReadingScale> of_fall(const std::string& channel) const {
    const AccelerationTable table = acceleration_table({task_.definition, task_.model, trials_, values_},
                                                       sensor_noise(task_.definition.structure.robot, trials_));
    for (const StackedAccelerations& one : stacked(table)) {
      if (one.channel != channel || one.measured.size() < kFewestOfAFall || !falls(table, channel)) continue;
      const Eigen::VectorXd fall = one.beside.col(0);
      Eigen::MatrixXd columns(fall.size(), 2);
      columns << fall, one.beside.col(3);
      const StraightFit fit = straight_fit(columns, one.measured);
      const double left = fit.squares / one.measured.squaredNorm();
      for (const NamedFactor& candidate : fall_factors())
        if (std::abs(fit.coefficients(0) / candidate.factor - 1.0) < kNamedFall && left < kExplainedFall &&
            fit.deviations(0) < kNamedFall * candidate.factor)
          return ReadingScale{{channel}, "m", candidate.factor, candidate.cause, 1.0, left};
    }
    return std::nullopt;
  }

 private:
  struct Tried {
    double factor;
    Squares squares;
  };

  /// Whether all other factors explain far less; neighbouring ones count as the same.
  static bool stands_alone(const std::vector<Tried>& tried, double factor, double least) {
    return std::none_of(tried.begin(), tried.end(), [&](const Tried& other) {
      const bool is_same = std::abs(std::log(other.factor / factor)) < kSameFactor;
      return !is_same && other.squares.written < kUnlikeOthers * least;
    });
  }

  bool is_lowest(const std::vector<std::string>& channels, double factor, double least) const {
    return squares(channels, kNeighbour * factor).written > least &&
           squares(channels, factor / kNeighbour).written > least;
  }

  /// Whether a channel falls by a steady acceleration, undriven.
  static bool falls(const AccelerationTable& table, const std::string& channel) {
    return std::all_of(table.channels.begin(), table.channels.end(), [&](const ChannelAccelerations& one) {
      if (one.channel != channel) return true;
      const double mean = one.uncommanded.mean();
      const double spread = (one.uncommanded.array() - mean).matrix().norm();
      return one.commanded.squaredNorm() == 0.0 &&
             spread < kSteadyFall * std::abs(mean) * std::sqrt(static_cast<double>(one.size()));
    });
  }

  const DataCheckTask& task_;
  std::vector<Trial> trials_;
  std::vector<double> values_;  ///< of the model as written
};

}  // namespace

std::optional<ReadingScale> reading_scale(const DataCheckTask& task) {
  const std::vector<JointReadings> joints = joint_readings(task.definition.structure.robot);
  if (joints.size() > kMostJoints) return std::nullopt;
  const ScaleSearch search(task);
  std::vector<std::string> angles;
  for (const JointReadings& joint : joints) {
    if (joint.turns)
      angles.insert(angles.end(), joint.channels.begin(), joint.channels.end());
    else if (auto found = search.of_fall(joint.channels.front()))
      return found;
  }
  if (angles.empty()) return std::nullopt;
  if (auto found = search.of_angles(angles)) return found;
  for (const JointReadings& joint : joints)
    if (joint.turns && joint.channels.size() < angles.size())
      if (auto found = search.of_angles(joint.channels)) return found;
  return std::nullopt;
}

std::string to_string(const ReadingScale& scale) {
  const bool small = scale.factor < 1.0;
  return fmt::format(
      "{}: the readings agree with the known forces after they are {} by {:.4g}, {}: the model as written then leaves "
      "{:.2g} % of the squared acceleration unexplained. Without the factor any inertia, stiffness, friction and gain "
      "leave {:.2g} %",
      fmt::join(scale.channels, ", "), small ? "multiplied" : "divided", small ? 1.0 / scale.factor : scale.factor,
      scale.cause, 100.0 * scale.after, 100.0 * scale.before);
}

}  // namespace lacuna
