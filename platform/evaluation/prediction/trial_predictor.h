#pragma once

#include <lacuna/trial.h>

#include "foundation/work.h"
#include "simulation/compiled_model.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// A stretch of a trial: its samples `first` ... `last − 1`.
struct Stretch {
  std::size_t trial = 0;
  Eigen::Index first = 0;
  Eigen::Index last = 0;
  Eigen::Index size() const { return last - first; }
  bool operator==(const Stretch&) const = default;
};

/// A simulation before a stretch that fills all memories up to the stretch's beginning.
struct WarmUp {
  Eigen::Index first = 0;  ///< sample of the trial, before the stretch's first
  StartState start;        ///< there
};

/// A model's prediction of a stretch. Reused from call to call, so that nothing is allocated again.
struct Prediction {
  bool valid = false;
  std::string reason;  ///< why it is not valid, a sentence
  /// Stretch size × measured channels of the trial, in their order; SI; undefined if not valid.
  TimeSeries::Samples samples;
  /// By measured channel: delay of its readings behind the motion at the beginning of the stretch, s.
  std::vector<double> lateness;
};

/// s: longer than most delays and lags.
inline constexpr double kLongestMemory = 0.1;

/// When a trial's commands act: as recorded, or all of them later by a value after the model's, in units of the trial's
/// command intervals.
enum class Timing { as_recorded, fitted };

/// s, average time between the commands of a trial, at most ten intervals of its readings: rarer rows may mark changes
/// of the command, not its sampling. 0 where there is at most one command.
double command_interval(const Trial& trial);

/// Predicts stretches of trials with one compiled model, for any values of its parameters. Measured channels are
/// matched to the model's by name once. Deterministic: a prediction depends only on its arguments. The model must
/// outlive the predictor; trials are copied.
class TrialPredictor {
 public:
  /// Makes a workspace for each thread of `work`. Throws `Error` when a trial measures a channel that the model does
  /// not have, in another unit, or when its initial values do not match the joints.
  TrialPredictor(const CompiledModel& model, std::vector<Trial> trials, const Work& work,
                 Timing timing = Timing::as_recorded);

  const CompiledModel& model() const { return model_; }
  const std::vector<Trial>& trials() const { return trials_; }
  int workers() const { return static_cast<int>(simulators_.size()); }
  /// What ends the work early for which it predicts; whoever predicts many stretches asks between them.
  const Stop& stop() const { return stop_; }
  /// All samples of a trial.
  Stretch whole(std::size_t trial) const { return {trial, 0, trials_[trial].measured.times.size()}; }

  /// Whether delays, lags and other memories of commands or readings may have an unknown content at a trial's start:
  /// the trial states neither the earlier commands nor a start at rest. For a model with such memories the first
  /// `kLongestMemory` s are then not used.
  bool past_is_unknown(std::size_t trial) const { return pasts_[trial] == Past::unknown; }

  /// Simulates from joint coordinates `start` at the time of the stretch's first sample, with the trial's commands at
  /// their recorded times, so that command delays receive the earlier commands. `values`: the model's, then the delay
  /// of commands where it is fitted; a controller's commands keep their time. `worker` names the workspace, one per
  /// thread. A simulation that fails makes the prediction invalid; arguments of a wrong size throw `Error`. With a
  /// warm-up, the simulation begins there and continues from `start` at the beginning of the stretch; coordinates that
  /// are NaN there continue from the warm-up.
  void predict(const Stretch& stretch, std::span<const double> values, const StartState& start, int worker,
               Prediction& prediction, const WarmUp* warm_up = nullptr) const;

  /// Whether the last value is the delay of commands.
  bool fits_timing() const { return timing_ == Timing::fitted; }

  /// Measured minus predicted, in the shape of the prediction; NaN where nothing was measured.
  void residuals(const Stretch& stretch, const Prediction& prediction, TimeSeries::Samples& residuals) const;

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// Commands before a trial's first sample.
  enum class Past {
    known,       ///< stated, or the trial is a test that began with its first command
    held_still,  ///< the commands that hold the robot at its start, with the values of a prediction
    unknown      ///< equal to the first command
  };

  /// Workspace of one thread.
  struct Desk {
    std::unique_ptr<Workspace> workspace;
    SimulationOptions options;
    SimulationResult result;
    std::size_t trial = kNone;  ///< whose test `own` has
    Test own;
  };

  Past past_of(Trial& trial) const;
  /// A quaternion and its negative are the same orientation: the predicted one gets the sign of the measured one.
  void align_orientations(const Stretch& stretch, TimeSeries::Samples& samples) const;
  /// The trial's test with its commands delayed, in command intervals, and before them the commands that hold the robot
  /// still.
  const Test& test_for(Desk& simulator, const Stretch& stretch, std::span<const double> values, double lateness) const;

  const CompiledModel& model_;
  std::vector<Trial> trials_;
  Timing timing_;
  Stop stop_;
  std::vector<Past> pasts_;                              ///< one a trial
  std::vector<Test> tests_;                              ///< one per trial: its commands
  std::vector<std::vector<Eigen::Index>> map_;           ///< per trial: measured channel → model channel
  std::vector<std::vector<Eigen::Index>> orientations_;  ///< per trial: first measured channel of each quaternion
  std::vector<std::unique_ptr<Desk>> simulators_;
};

}  // namespace lacuna
