#include "data_checks/acceleration_table.h"

#include "data_checks/channel_scatter.h"
#include "foundation/address.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace lacuna {
namespace {

constexpr std::array kStretches = {0.1, 0.2, 0.4};  // s
constexpr double kClear = 5.0;                      // RMS of measured accelerations over their noise
constexpr Eigen::Index kFewestSamples = 6;
constexpr Eigen::Index kFewestStretches = 5;
constexpr double kTooLarge = 10.0;  // ratio of predicted to measured accelerations
constexpr double kRest = 0.1;       // of the RMS velocity

/// A channel that measures a joint coordinate.
struct Source {
  Eigen::Index column;
  int order;
  std::size_t coordinate;
};

std::vector<Source> sources_of(const RobotSpec& robot, const CompiledModel& model, const Trial& trial) {
  std::vector<Source> sources;
  for (const SensorSpec& sensor : robot.sensors) {
    const bool position = sensor.kind == SensorKind::joint_position;
    if (!position && sensor.kind != SensorKind::joint_velocity) continue;
    const std::vector<Channel> channels = sensor_channels(robot, sensor);
    if (channels.size() != 1) continue;
    const auto column = std::find(trial.measured.channels.begin(), trial.measured.channels.end(), channels.front());
    const auto coordinate = std::find_if(model.coordinates().begin(), model.coordinates().end(),
                                         [&](const Coordinate& one) { return one.name == "joint." + sensor.element; });
    if (column == trial.measured.channels.end() || coordinate == model.coordinates().end()) continue;
    sources.push_back({column - trial.measured.channels.begin(), position ? 2 : 1,
                       static_cast<std::size_t>(coordinate - model.coordinates().begin())});
  }
  return sources;
}

/// Weights of the samples in the second derivative of the parabola, or the slope of the line, through them.
Eigen::VectorXd weights_of(const Eigen::VectorXd& times, int order) {
  const double middle = 0.5 * (times(0) + times(times.size() - 1)), half = times(times.size() - 1) - middle;
  Eigen::MatrixXd powers = Eigen::MatrixXd::Ones(times.size(), order + 1);
  for (int degree = 1; degree <= order; ++degree)
    powers.col(degree) = powers.col(degree - 1).cwiseProduct(((times.array() - middle) / half).matrix());
  const Eigen::MatrixXd gram = powers.transpose() * powers;
  const Eigen::VectorXd highest = gram.ldlt().solve(Eigen::VectorXd::Unit(order + 1, order));
  return powers * highest * (order == 2 ? 2.0 / (half * half) : 1.0 / half);
}

/// The trials with the commands of one actuator alone, scaled by `share`.
std::vector<Trial> silenced(std::vector<Trial> trials, const std::string& all_but, double share) {
  for (Trial& trial : trials) {
    TimeSeries& commands = trial.commands.series;
    for (std::size_t c = 0; c < commands.channels.size(); ++c)
      commands.samples.col(static_cast<Eigen::Index>(c)) *= commands.channels[c].name == all_but ? share : 0.0;
  }
  return trials;
}

ChannelAccelerations selected(const ChannelAccelerations& all, const std::vector<Eigen::Index>& rows) {
  ChannelAccelerations some = all;
  some.measured = all.measured(rows);
  some.uncommanded = all.uncommanded(rows);
  some.commanded = all.commanded(rows, Eigen::all);
  some.position = all.position(rows);
  some.velocity = all.velocity(rows);
  some.first.clear();
  some.weights.clear();
  for (const Eigen::Index row : rows) {
    some.first.push_back(all.first[static_cast<std::size_t>(row)]);
    some.weights.push_back(all.weights[static_cast<std::size_t>(row)]);
  }
  return some;
}

/// Leaves out the stretches in which the joint rests or turns: dry friction may hold any force there.
void leave_out_rest(std::vector<ChannelAccelerations>& channels) {
  std::map<std::string, std::pair<double, double>> speeds;  // squares, count
  for (const ChannelAccelerations& one : channels) {
    speeds[one.channel].first += one.velocity.squaredNorm();
    speeds[one.channel].second += static_cast<double>(one.size());
  }
  for (ChannelAccelerations& one : channels) {
    const auto& [squares, count] = speeds[one.channel];
    const double rest = kRest * std::sqrt(squares / count);
    std::vector<Eigen::Index> moving;
    for (Eigen::Index i = 0; i < one.size(); ++i)
      if (std::abs(one.velocity(i)) >= rest) moving.push_back(i);
    one = selected(one, moving);
  }
  std::erase_if(channels, [](const ChannelAccelerations& one) { return one.size() < kFewestStretches; });
}

/// Makes the table for one length of stretch.
class Maker {
 public:
  /// `share`: factor on the simulated commands; their effect is scaled up again.
  Maker(const DataCheckTask& task, const std::vector<Trial>& trials, const std::vector<ChannelNoise>& noise,
        double share)
      : task_(task), noise_(noise), trials_(trials), share_(share) {
    predictors_.reserve(task.definition.structure.robot.actuators.size() + 1);
    const Work work{1, task.stop};
    predictors_.emplace_back(task.model, silenced(trials, "", share), work);
    for (const ActuatorSpec& actuator : task.definition.structure.robot.actuators)
      predictors_.emplace_back(task.model, silenced(trials, actuator.name, share), work);
    states_.emplace(task.definition.structure.robot, predictors_.front(), noise);
  }

  bool possible() const {
    for (std::size_t trial = 0; trial < trials_.size(); ++trial)
      if (!states_->reconstructible(trial)) return false;
    return true;
  }

  AccelerationTable table(double stretch) {
    AccelerationTable table{trials_, stretch, {}};
    for (std::size_t trial = 0; trial < trials_.size(); ++trial) add(trial, stretch, table.channels);
    leave_out_rest(table.channels);
    return table;
  }

 private:
  void add(std::size_t trial, double length, std::vector<ChannelAccelerations>& channels) {
    const Eigen::VectorXd& times = trials_[trial].measured.times;
    const std::vector<Source> sources = sources_of(task_.definition.structure.robot, task_.model, trials_[trial]);
    std::vector<std::vector<Row>> rows(sources.size());
    for (Eigen::Index first = 0, last = 0; first < times.size(); first = last) {
      while (last < times.size() && times(last) - times(first) < length) ++last;
      if (last == times.size()) break;  // the remaining part is shorter
      if (last - first >= kFewestSamples) add_stretch({trial, first, last}, sources, rows);
    }
    for (std::size_t s = 0; s < sources.size(); ++s)
      if (static_cast<Eigen::Index>(rows[s].size()) >= kFewestStretches)
        channels.push_back(collected(trial, sources[s], rows[s]));
  }

  struct Row {
    double measured, uncommanded, position, velocity;
    Eigen::VectorXd commanded, weights;
    Eigen::Index first;
  };

  void add_stretch(const Stretch& stretch, const std::vector<Source>& sources, std::vector<std::vector<Row>>& rows) {
    const TimeSeries& measured = trials_[stretch.trial].measured;
    const Eigen::Index before = std::max(stretch.first - stretch.size() / 2, Eigen::Index{0});
    const StartEstimate start = states_->from_samples({stretch.trial, before, stretch.last}, stretch.first);
    const Stretch whole = predictors_.front().whole(stretch.trial);
    const StartEstimate middle = states_->from_samples(whole, stretch.first + stretch.size() / 2);
    if (!start.valid || !middle.valid) return;
    std::vector<TimeSeries::Samples> predicted;
    for (const TrialPredictor& predictor : predictors_) {
      predictor.predict(stretch, task_.values, start.start, 0, prediction_);
      if (!prediction_.valid) return;
      predicted.push_back(prediction_.samples);
    }
    const Eigen::VectorXd times = measured.times.segment(stretch.first, stretch.size());
    for (std::size_t s = 0; s < sources.size(); ++s) {
      const auto& [column, order, coordinate] = sources[s];
      const Eigen::VectorXd values = measured.samples.col(column).segment(stretch.first, stretch.size());
      if (!values.allFinite()) continue;
      Row row;
      row.weights = weights_of(times, order);
      row.first = stretch.first;
      row.measured = row.weights.dot(values);
      row.uncommanded = row.weights.dot(predicted.front().col(column));
      row.commanded.resize(static_cast<Eigen::Index>(predicted.size()) - 1);
      for (Eigen::Index u = 0; u < row.commanded.size(); ++u)
        row.commanded(u) =
            (row.weights.dot(predicted[static_cast<std::size_t>(u) + 1].col(column)) - row.uncommanded) / share_;
      row.position = middle.start.positions[coordinate];
      row.velocity = middle.start.velocities[coordinate];
      rows[s].push_back(std::move(row));
    }
  }

  ChannelAccelerations collected(std::size_t trial, const Source& source, const std::vector<Row>& rows) const {
    const Channel& channel = trials_[trial].measured.channels[static_cast<std::size_t>(source.column)];
    const auto count = static_cast<Eigen::Index>(rows.size());
    ChannelAccelerations all;
    all.trial = trial;
    all.column = source.column;
    all.channel = channel.name;
    all.unit = source.order == 2 ? channel.unit + "/s^2" : channel.unit.substr(0, channel.unit.find('/')) + "/s^2";
    all.order = source.order;
    all.measured.resize(count);
    all.uncommanded.resize(count);
    all.position.resize(count);
    all.velocity.resize(count);
    all.commanded.resize(count, rows.front().commanded.size());
    for (Eigen::Index i = 0; i < count; ++i) {
      const Row& row = rows[static_cast<std::size_t>(i)];
      all.measured(i) = row.measured;
      all.uncommanded(i) = row.uncommanded;
      all.position(i) = row.position;
      all.velocity(i) = row.velocity;
      all.commanded.row(i) = row.commanded;
      all.first.push_back(row.first);
      all.weights.push_back(row.weights);
    }
    double noise = scatter_of(trials_[trial].measured, source.column);
    for (const ChannelNoise& known : noise_)
      if (known.channel == channel.name) noise = std::max(noise, known.deviation);
    all.deviation = noise * rows.front().weights.norm();
    return all;
  }

  const DataCheckTask& task_;
  const std::vector<ChannelNoise>& noise_;
  const std::vector<Trial>& trials_;
  const double share_;
  std::vector<TrialPredictor> predictors_;  ///< without commands, then with the commands of one actuator alone
  std::optional<StartStates> states_;
  Prediction prediction_;
};

double commanded_over_measured(const AccelerationTable& table) {
  double commanded = 0.0, measured = 0.0;
  for (const ChannelAccelerations& one : table.channels) {
    commanded += one.commanded.squaredNorm();
    measured += one.measured.squaredNorm();
  }
  return measured > 0.0 ? std::sqrt(commanded / measured) : 0.0;
}

}  // namespace

double clearness(const AccelerationTable& table) {
  double squares = 0.0, count = 0.0;
  for (const ChannelAccelerations& one : table.channels) {
    squares += (one.measured / one.deviation).squaredNorm();
    count += static_cast<double>(one.size());
  }
  return std::sqrt(squares / std::max(count, 1.0));
}

AccelerationTable acceleration_table(const DataCheckTask& task, const std::vector<ChannelNoise>& noise) {
  std::vector<Trial> trials;
  std::copy_if(task.trials.begin(), task.trials.end(), std::back_inserter(trials),
               [](const Trial& one) { return !one.held_out; });
  if (trials.empty()) return {};
  Maker maker(task, trials, noise, 1.0);
  if (!maker.possible()) return {};
  AccelerationTable table;
  for (const double stretch : kStretches) {
    AccelerationTable longer = maker.table(stretch);
    if (longer.empty()) continue;
    table = std::move(longer);
    if (clearness(table) >= kClear) break;
  }
  // Commands that are far too large would move the model beyond what a parabola describes.
  const double beyond = commanded_over_measured(table);
  return beyond > kTooLarge ? Maker(task, trials, noise, 1.0 / beyond).table(table.stretch) : table;
}

}  // namespace lacuna
