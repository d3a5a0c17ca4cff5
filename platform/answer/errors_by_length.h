#pragma once

#include "answer/diagnosis.h"
#include "search/effect_search.h"

#include <string>
#include <vector>

namespace lacuna {

/// Prediction errors of one model by length and channel, in the unit of the channel: noise of a reading × RMS of the
/// whitened residuals. NaN where nothing is read or the model cannot be simulated.
class ErrorsByLength {
 public:
  /// With the values of a set, over all lengths of the search, also on held-out trials where the task has some.
  ErrorsByLength(const SearchData& data, const FittedModel& set);

  bool is_read(std::size_t length, std::size_t channel) const;
  double fitted(std::size_t length, std::size_t channel) const { return error(fitted_, length, channel); }
  double held_out(std::size_t length, std::size_t channel) const { return error(held_out_, length, channel); }
  /// RMS of all whitened residuals; lengths and joints have the weights of the cost.
  double times_floor() const;
  /// Over the longest predictions of each channel.
  std::vector<ChannelError> longest() const;
  /// s, of the longest predictions
  double longest_length() const;

 private:
  double error(const Eigen::VectorXd& mean_squares, std::size_t length, std::size_t channel) const;

  const PredictionLadder& ladder_;
  Eigen::VectorXd fitted_, held_out_;  ///< mean squares by cell; empty: no held-out trials
};

/// Fit and held-out errors side by side, for every length and channel that is read.
std::vector<HorizonError> errors_by_horizon(const SearchData& data, const ErrorsByLength& base,
                                            const ErrorsByLength& answer);

}  // namespace lacuna
