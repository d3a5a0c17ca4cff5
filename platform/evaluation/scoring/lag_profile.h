#pragma once

#include "evaluation/model/model_definition.h"
#include "evaluation/scoring/scored_trial.h"

#include <cstddef>
#include <span>
#include <vector>

namespace lacuna {

/// One thread's record of a model's readings without delay, on which delays are tried.
using TrialReadings = std::vector<TimeSeries::Samples>;  ///< one per trial: samples × measured channels

/// Finds delays of sensors without simulating. Where commands are replayed, a delay only shifts the readings of a
/// sensor, so the best delay is the one at which the shifted readings are nearest to the measured ones, sensor by
/// sensor. Before the first reading a delayed sensor reads its value at the start. Const and shared by threads.
class LagProfile {
 public:
  LagProfile() = default;
  /// `delays`: indices of free values `sensor.<name>.delay`. `trials` must outlive it; they all measure the channels of
  /// the first.
  LagProfile(const ModelDefinition& model, const std::vector<std::size_t>& delays,
             const std::vector<ScoredTrial>& trials);

  bool empty() const { return lags_.empty(); }
  /// Sets the delays to zero, as needed for the readings that are passed to `fit`.
  void clear_delays(std::span<double> values) const {
    for (const Lag& lag : lags_) values[lag.value] = 0.0;
  }
  /// Shifts `readings` by the delays that fit best, by mean absolute differences over all trials, and writes the
  /// delays, s, into `values`. Of delays that fit equally well the smallest.
  void fit(TrialReadings& readings, std::span<double> values) const;

 private:
  struct Lag {
    std::size_t value = 0;               ///< index of the free value
    std::vector<Eigen::Index> channels;  ///< measured
    double longest = 0.0;                ///< s
  };
  double best_delay(const Lag& lag, const TrialReadings& readings) const;
  double difference(const Lag& lag, const TrialReadings& readings, double delay) const;

  const std::vector<ScoredTrial>* trials_ = nullptr;
  std::vector<Lag> lags_;
  double step_ = 0.0;         ///< s, between the delays that are tried
  bool whole_steps_ = false;  ///< only multiples of it make a difference
};

}  // namespace lacuna
