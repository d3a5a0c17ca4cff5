#include "where_it_fails/state_features.h"

#include "foundation/statistics.h"
#include "where_it_fails/model_state.h"
#include "where_it_fails/motion.h"
#include "fitting/starts/start_states.h"
#include "foundation/address.h"
#include "foundation/parallel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lacuna {
namespace {

constexpr double kFollows = 3.0;  // times the floor: within this error the model's state is as good as the measured one
constexpr double kRestShare = 0.02;    // of the RMS velocity; slower counts as rest
constexpr double kRestDeviations = 3;  // standard deviations of a measured velocity; slower counts as rest
constexpr double kRepeats = 0.999;     // correlation with an earlier feature; more counts as a repetition

bool usable(const TrialComparison& trial) {
  return trial.valid && !trial.held_out &&
         std::any_of(trial.channels.begin(), trial.channels.end(),
                     [](const ChannelScore& score) { return score.samples > 0 && std::isfinite(score.floor); });
}

bool follows(const TrialComparison& trial) {
  return std::all_of(trial.channels.begin(), trial.channels.end(),
                     [](const ChannelScore& score) { return score.samples == 0 || score.times_floor <= kFollows; });
}

/// The value of a command at a time, held between samples.
double command_at(const CommandSeries& commands, Eigen::Index channel, double time) {
  const TimeSeries& series = commands.series;
  const double* begin = series.times.data();
  const Eigen::Index after = std::upper_bound(begin, begin + series.times.size(), time) - begin;
  const Eigen::Index before = std::max<Eigen::Index>(0, after - 1);
  if (commands.hold == Hold::zero_order || after == 0 || after == series.times.size())
    return series.samples(before, channel);
  const double share = (time - series.times(before)) / (series.times(after) - series.times(before));
  return (1.0 - share) * series.samples(before, channel) + share * series.samples(after, channel);
}

/// Positions and velocities of the coordinates at some samples.
struct Kinematics {
  Eigen::MatrixXd positions, velocities;
  Eigen::VectorXd rest;  ///< one per coordinate: speeds that count as rest
};

class FeatureBuilder {
 public:
  FeatureBuilder(const FeatureTask& task, std::size_t most)
      : task_(task),
        robot_(task.definition.structure.robot),
        model_states_(task.definition, task.work.stop),
        noise_(sensor_noise(robot_, task.trials)),
        predictor_(task.model, task.trials, {1, task.work.stop}),
        states_(robot_, predictor_, noise_) {
    choose_rows(std::max<std::size_t>(most, 1));
    name_features();
  }

  FeatureTable build() {
    table_.values.resize(static_cast<Eigen::Index>(table_.trial.size()),
                         static_cast<Eigen::Index>(table_.features.size()));
    parallel_for(used_.size(), task_.work.threads, [&](std::size_t i, int) {
      task_.work.stop.throw_if_due();
      fill(used_[i]);
    });
    drop_idle();
    return std::move(table_);
  }

 private:
  struct Used {
    std::size_t trial = 0;
    Eigen::Index first_row = 0;
    std::vector<Eigen::Index> samples;
  };

  void choose_rows(std::size_t most) {
    std::size_t all = 0;
    const auto scored = [](const TrialComparison& trial) {
      return static_cast<std::size_t>(std::max<Eigen::Index>(0, trial.times.size() - trial.first_scored));
    };
    for (const TrialComparison& trial : task_.comparison.trials)
      if (usable(trial)) all += scored(trial);
    const auto stride = static_cast<Eigen::Index>((all + most - 1) / most);
    for (std::size_t t = 0; t < task_.comparison.trials.size(); ++t) {
      const TrialComparison& trial = task_.comparison.trials[t];
      if (!usable(trial)) continue;
      Used used{t, static_cast<Eigen::Index>(table_.trial.size()), {}};
      for (Eigen::Index sample = trial.first_scored; sample < trial.times.size(); sample += stride) {
        used.samples.push_back(sample);
        table_.trial.push_back(t);
        table_.sample.push_back(sample);
      }
      used_.push_back(std::move(used));
    }
  }

  /// The most natural features come first: of two that repeat each other the first is kept.
  void name_features() {
    const std::vector<Coordinate>& coordinates = model_states_.coordinates();
    const std::vector<Channel> commands = command_channels(robot_);
    const std::vector<std::string>& bodies = model_states_.bodies();
    const auto of = [](std::size_t count, const std::string& element) { return count > 1 ? element : std::string(); };
    const auto add = [&](FeatureKind kind, const std::string& name, const std::string& element,
                         const std::string& unit) {
      table_.features.push_back({kind, name, element, unit});
    };
    for (const Coordinate& one : coordinates) {
      const std::string element = of(coordinates.size(), one.name);
      add(FeatureKind::position, "position", element, one.unit);
      add(FeatureKind::velocity, "velocity", element, one.unit + "/s");
      add(FeatureKind::speed, "|velocity|", element, one.unit + "/s");
      add(FeatureKind::direction, "direction of motion", element, "1");
      add(FeatureKind::since_reversal, "time since the last reversal", element, "s");
    }
    for (const Channel& one : commands)
      add(FeatureKind::command, "command", of(commands.size(), "actuator." + one.name), one.unit);
    for (const std::string& body : bodies) add(FeatureKind::contact, "contact", of(bodies.size(), "body." + body), "1");
    add(FeatureKind::time, "time", "", "s");
    for (const Coordinate& one : coordinates) {
      const std::string element = of(coordinates.size(), one.name);
      add(FeatureKind::load, "load", element, one.unit == "m" ? "N" : "N*m");
      add(FeatureKind::work, "accumulated work", element, "J");
    }
  }

  /// The columns in the order of `name_features`.
  void fill(const Used& used) {
    const TrialComparison& comparison = task_.comparison.trials[used.trial];
    const Trial& trial = task_.trials[used.trial];
    const std::optional<ModelState> model =
        comparison.pieces.size() > 1 ? std::nullopt : model_states_.of(trial, comparison.start, task_.values);
    const Kinematics motion = kinematics(used, model);
    const Eigen::VectorXd times = comparison.times(used.samples);
    Eigen::Index column = 0;
    const auto write = [&](const Eigen::VectorXd& values) {
      table_.values.col(column++).segment(used.first_row, values.size()) = values;
    };
    const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(times.size());
    for (Eigen::Index c = 0; c < motion.positions.cols(); ++c) {
      const Motion turns = motion_of(times, motion.velocities.col(c), motion.rest(c));
      write(motion.positions.col(c));
      write(motion.velocities.col(c));
      write(motion.velocities.col(c).cwiseAbs());
      write(turns.direction);
      write(turns.since_reversal);
    }
    for (const Channel& channel : command_channels(robot_)) write(commanded(trial, channel.name, times));
    for (std::size_t b = 0; b < model_states_.bodies().size(); ++b)
      write(model ? Eigen::VectorXd(model->contacts.col(static_cast<Eigen::Index>(b))(used.samples)) : nothing);
    write(times);
    for (Eigen::Index c = 0; c < motion.positions.cols(); ++c) {
      const Eigen::VectorXd load = model ? Eigen::VectorXd(model->loads.col(c)(used.samples)) : nothing;
      write(load);
      write(accumulated(times, load.cwiseProduct(motion.velocities.col(c)).cwiseAbs()));
    }
  }

  Kinematics kinematics(const Used& used, const std::optional<ModelState>& model) const {
    const auto n = static_cast<Eigen::Index>(model_states_.coordinates().size());
    const auto size = static_cast<Eigen::Index>(used.samples.size());
    Kinematics motion{Eigen::MatrixXd::Zero(size, n), Eigen::MatrixXd::Zero(size, n), Eigen::VectorXd::Zero(n)};
    if (model) {
      motion.positions = model->positions(used.samples, Eigen::all);
      motion.velocities = model->velocities(used.samples, Eigen::all);
    }
    if (!model || !follows(task_.comparison.trials[used.trial])) take_measured(used, motion);
    for (Eigen::Index c = 0; c < n; ++c)
      motion.rest(c) = std::max(motion.rest(c), kRestShare * root_mean_square(motion.velocities.col(c)));
    return motion;
  }

  void take_measured(const Used& used, Kinematics& motion) const {
    const Stretch whole = predictor_.whole(used.trial);
    const int n = states_.coordinates();
    std::vector<double> uncertainty(static_cast<std::size_t>(n), 0.0);
    for (std::size_t i = 0; i < used.samples.size(); ++i) {
      const StartEstimate at = states_.from_samples(whole, used.samples[i]);
      const auto row = static_cast<Eigen::Index>(i);
      for (int c = 0; c < n; ++c) {
        if (std::isfinite(at.deviation(c))) motion.positions(row, c) = component(at.start, c);
        if (!std::isfinite(at.deviation(n + c))) continue;
        motion.velocities(row, c) = component(at.start, n + c);
        uncertainty[static_cast<std::size_t>(c)] += at.deviation(n + c) / static_cast<double>(used.samples.size());
      }
    }
    for (int c = 0; c < n; ++c) motion.rest(c) = kRestDeviations * uncertainty[static_cast<std::size_t>(c)];
  }

  static Eigen::VectorXd accumulated(const Eigen::VectorXd& times, const Eigen::VectorXd& power) {
    Eigen::VectorXd work = Eigen::VectorXd::Zero(times.size());
    for (Eigen::Index i = 1; i < times.size(); ++i)
      work(i) = work(i - 1) + 0.5 * (power(i) + power(i - 1)) * (times(i) - times(i - 1));
    return work;
  }

  static Eigen::VectorXd commanded(const Trial& trial, const std::string& actuator, const Eigen::VectorXd& times) {
    const std::vector<Channel>& channels = trial.commands.series.channels;
    const auto found =
        std::find_if(channels.begin(), channels.end(), [&](const auto& one) { return one.name == actuator; });
    if (found == channels.end() || trial.commands.series.times.size() == 0) return Eigen::VectorXd::Zero(times.size());
    return times.unaryExpr([&](double time) { return command_at(trial.commands, found - channels.begin(), time); });
  }

  /// Leaves out what does not vary or repeats another feature.
  void drop_idle() {
    std::vector<Eigen::Index> kept;
    std::vector<StateFeature> features;
    std::vector<Eigen::VectorXd> units;  // kept columns, centred, of length 1
    for (Eigen::Index f = 0; f < table_.values.cols(); ++f) {
      Eigen::VectorXd column = table_.values.col(f);
      if (!column.allFinite() || column.size() == 0) continue;
      const double size = column.norm();
      column.array() -= column.mean();
      if (!(column.norm() > 1e-9 * size)) continue;
      column.normalize();
      if (std::any_of(units.begin(), units.end(),
                      [&](const auto& other) { return std::abs(other.dot(column)) > kRepeats; }))
        continue;
      kept.push_back(f);
      features.push_back(table_.features[static_cast<std::size_t>(f)]);
      units.push_back(std::move(column));
    }
    table_.values = table_.values(Eigen::all, kept).eval();
    table_.features = std::move(features);
  }

  const FeatureTask& task_;
  const RobotSpec& robot_;
  ModelStates model_states_;
  std::vector<ChannelNoise> noise_;
  TrialPredictor predictor_;
  StartStates states_;
  std::vector<Used> used_;
  FeatureTable table_;
};

}  // namespace

FeatureTable state_features(const FeatureTask& task, std::size_t rows) { return FeatureBuilder(task, rows).build(); }

}  // namespace lacuna
