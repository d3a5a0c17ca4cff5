#include "fitting/floor/noise_floor.h"

#include "evaluation/prediction/trial_predictor.h"
#include "fitting/floor/disturbance.h"
#include "fitting/floor/free_run.h"
#include "foundation/parallel.h"
#include "foundation/unit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

/// Streams of the seed, so that the two kinds of noise are independent.
constexpr std::uint64_t kCommandStream = 1ULL << 32;
constexpr std::uint64_t kForceStream = 2ULL << 32;

/// Sums of squared deviations of one draw, one value per channel; invalid draws do not count.
struct Departure {
  bool valid = false;
  Eigen::VectorXd squares;
};

/// Change of the prediction from `base` by `commands`, over the scored samples.
Departure departure(const CompiledModel& model, const Trial& trial, CommandSeries commands, const ScoredStart& start,
                    const std::vector<double>& values, const Prediction& base, const Stop& stop) {
  stop.throw_if_due();
  Trial disturbed = trial;
  disturbed.commands = std::move(commands);
  const TrialPredictor predictor(model, {std::move(disturbed)}, {1, stop});
  const Prediction prediction = predict_again(predictor, 0, *start.pieces, values, 0);
  if (!prediction.valid) return {};
  const Eigen::Index rows = prediction.samples.rows() - start.first_scored;
  return {true, (prediction.samples - base.samples).bottomRows(rows).colwise().squaredNorm().transpose()};
}

Eigen::VectorXd unknown(Eigen::Index channels) {
  return Eigen::VectorXd::Constant(channels, std::numeric_limits<double>::quiet_NaN());
}

/// RMS over draws and scored samples, one value per channel; NaN where no draw could be simulated.
Eigen::VectorXd rms(const std::vector<Departure>& draws, Eigen::Index channels, Eigen::Index rows) {
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(channels);
  double count = 0.0;
  for (const Departure& draw : draws)
    if (draw.valid) {
      squares += draw.squares;
      count += static_cast<double>(rows);
    }
  return count > 0.0 ? Eigen::VectorXd((squares / count).cwiseSqrt()) : unknown(channels);
}

std::string part(const std::string& cause, double size, const std::string& unit) {
  if (std::isnan(size))
    return "; the contribution of " + cause + " is unknown, because no run with it could be simulated";
  return size > 0.0 ? "; " + cause + " adds " + format_quantity(size, unit) : "";
}

std::string sentence(const FloorValue& value, const std::string& sensor_origin) {
  std::string text = sensor_origin;
  text += part("command noise", value.input, value.unit);
  text += part("random force", value.process, value.unit);
  return text;
}

/// The floor of the trials of one task.
class Propagation {
 public:
  explicit Propagation(const NoiseFloorTask& task)
      : task_(task), joints_(disturbed_joints(task.definition.structure.robot, task.noise)) {
    if (!joints_.empty()) disturbed_model_ = compile_disturbed(task.definition, joints_);
  }

  TrialFloor floor(std::size_t index) const {
    const Trial& trial = task_.trials[index];
    const auto channels = static_cast<Eigen::Index>(trial.measured.channels.size());
    const bool noisy_commands = std::any_of(trial.command_noise.begin(), trial.command_noise.end(),
                                            [](double deviation) { return deviation > 0.0; });
    const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(channels);
    const Eigen::VectorXd input = noisy_commands ? passed_through(index, false) : nothing;
    const Eigen::VectorXd process = joints_.empty() ? nothing : passed_through(index, true);
    TrialFloor floor{trial.name, {}};
    for (Eigen::Index c = 0; c < channels; ++c) {
      const Channel& channel = trial.measured.channels[static_cast<std::size_t>(c)];
      const auto noise = std::find_if(task_.sensors.begin(), task_.sensors.end(),
                                      [&](const ChannelNoise& one) { return one.channel == channel.name; });
      FloorValue value{channel.name, channel.unit, noise->deviation, input(c), process(c), 0.0, ""};
      value.total = std::sqrt(value.sensor * value.sensor + value.input * value.input + value.process * value.process);
      value.origin = sentence(value, noise->origin);
      floor.channels.push_back(std::move(value));
    }
    return floor;
  }

 private:
  /// Standard deviation of the prediction under random forces, or else under command noise.
  Eigen::VectorXd passed_through(std::size_t index, bool forces) const {
    const Trial& trial = task_.trials[index];
    const CompiledModel& model = forces ? *disturbed_model_ : task_.model;
    const ScoredStart& start = task_.starts[index];
    const auto channels = static_cast<Eigen::Index>(trial.measured.channels.size());
    const TrialPredictor predictor(task_.model, {trial}, {1, task_.work.stop});
    const Prediction base = predict_again(predictor, 0, *start.pieces, task_.values, 0);
    if (!base.valid) return unknown(channels);
    std::vector<Departure> draws(kNoiseDraws);
    parallel_for(draws.size(), task_.work.threads, [&](std::size_t draw, int) {
      draws[draw] = departure(model, trial, forces ? forced(trial, index, draw) : noisy(trial, index, draw), start,
                              task_.values, base, task_.work.stop);
    });
    return rms(draws, channels, trial.measured.times.size() - start.first_scored);
  }

  CommandSeries noisy(const Trial& trial, std::size_t index, std::size_t draw) const {
    return with_command_noise(trial.commands, trial.command_noise, task_.seed,
                              kCommandStream + index * kNoiseDraws + draw);
  }
  CommandSeries forced(const Trial& trial, std::size_t index, std::size_t draw) const {
    const Eigen::VectorXd& times = trial.measured.times;
    return with_random_forces(trial.commands, joints_, task_.definition.engine.step,
                              task_.noise.process_correlation_time, times(0), times(times.size() - 1), task_.seed,
                              kForceStream + index * kNoiseDraws + draw);
  }

  const NoiseFloorTask& task_;
  std::vector<DisturbedJoint> joints_;
  std::unique_ptr<CompiledModel> disturbed_model_;
};

}  // namespace

std::vector<TrialFloor> noise_floor(const NoiseFloorTask& task) {
  const Propagation propagation(task);
  std::vector<TrialFloor> floors;
  for (std::size_t index = 0; index < task.trials.size(); ++index) floors.push_back(propagation.floor(index));
  return floors;
}

}  // namespace lacuna
