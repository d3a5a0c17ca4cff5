#pragma once

#include <lacuna/trial.h>

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

/// What is simulated before a stretch, so that all that has a memory is filled where the stretch begins.
struct WarmUp {
  Eigen::Index first = 0;  ///< sample of the trial, before the stretch's first
  StartState start;        ///< there
};

/// What a model says about a stretch. Reused from call to call, so that nothing is allocated anew.
struct Prediction {
  bool valid = false;
  std::string reason;  ///< why it is not valid, a sentence
  TimeSeries::Samples
      samples;  ///< stretch size × measured channels of the trial, in their order; SI; of no meaning if not valid
  /// By measured channel: by how much later than the motion its readings are where the stretch begins, s.
  std::vector<double> lateness;
};

/// s: longer than most delays and lags.
inline constexpr double kLongestMemory = 0.1;

/// When a trial's commands act: as recorded, or all of them later by a value that follows the model's, counted in the
/// trial's command intervals.
enum class Timing { as_recorded, fitted };

/// s, between the commands of a trial, on average, but at most ten intervals of its readings: rarer rows may say
/// when a command changes, not how often it is recorded. 0 where there is one command at most.
double command_interval(const Trial& trial);

/// Predicts stretches of trials with one compiled model, for any values of its parameters. Measured
/// channels are matched to the model's by name once. Deterministic: a prediction depends on its
/// arguments alone. The model must outlive the predictor; trials are copied.
class TrialPredictor {
 public:
  /// Makes a workspace for each of `workers` threads. Throws `Error` when a trial measures a channel
  /// that the model does not have, in another unit, or when its initial values do not fit the joints.
  TrialPredictor(const CompiledModel& model, std::vector<Trial> trials, int workers,
                 Timing timing = Timing::as_recorded);

  const CompiledModel& model() const { return model_; }
  const std::vector<Trial>& trials() const { return trials_; }
  int workers() const { return static_cast<int>(desks_.size()); }
  /// All samples of a trial.
  Stretch whole(std::size_t trial) const { return {trial, 0, trials_[trial].measured.times.size()}; }

  /// Whether delays, lags and other memories of commands or readings may hold at a trial's start what nobody knows: the
  /// trial states neither what was commanded before nor a start at rest. The first `kLongestMemory` s tell nothing then
  /// of a model that has such memories.
  bool past_is_unknown(std::size_t trial) const { return pasts_[trial] == Past::unknown; }

  /// Simulates from joint coordinates `start` at the time of the stretch's first sample, the trial's
  /// commands replayed by the trial's own clock, so that command delays see what was commanded before. `values`: the
  /// model's, then by how much later commands act where that is fitted; a controller's own commands keep their time.
  /// `worker` names the workspace, one a thread. A simulation that fails makes the prediction invalid;
  /// arguments that do not fit throw `Error`. With a warm-up, the simulation begins there and goes on from `start`
  /// where the stretch begins; coordinates that are NaN there go on as the warm-up leaves them.
  void predict(const Stretch& stretch, std::span<const double> values, const StartState& start, int worker,
               Prediction& prediction, const WarmUp* warm_up = nullptr) const;

  /// Whether the last value is when commands act.
  bool fits_timing() const { return timing_ == Timing::fitted; }

  /// Measured minus predicted, in the shape of the prediction; NaN where nothing was measured.
  void residuals(const Stretch& stretch, const Prediction& prediction, TimeSeries::Samples& residuals) const;

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// What was commanded before a trial's first sample.
  enum class Past {
    known,       ///< stated, or the trial is a test that began with its first command
    held_still,  ///< what held the robot at its start, with the values of a prediction
    unknown      ///< the first command is taken for it
  };

  /// What one thread works with.
  struct Desk {
    std::unique_ptr<Workspace> workspace;
    SimulationOptions options;
    SimulationResult result;
    std::size_t trial = kNone;  ///< whose test `own` has
    Test own;
  };

  Past past_of(Trial& trial) const;
  /// A quaternion and its opposite are the same orientation: the predicted one takes the measured one's side.
  void align_orientations(const Stretch& stretch, TimeSeries::Samples& samples) const;
  /// The trial's test, its commands so much later, in command intervals, and before them what held the robot still.
  const Test& test_for(Desk& desk, const Stretch& stretch, std::span<const double> values, double lateness) const;

  const CompiledModel& model_;
  std::vector<Trial> trials_;
  Timing timing_;
  std::vector<Past> pasts_;                              ///< one a trial
  std::vector<Test> tests_;                              ///< one a trial: its commands
  std::vector<std::vector<Eigen::Index>> map_;           ///< per trial: measured channel → model channel
  std::vector<std::vector<Eigen::Index>> orientations_;  ///< per trial: first measured channel of each quaternion
  std::vector<std::unique_ptr<Desk>> desks_;
};

}  // namespace lacuna
