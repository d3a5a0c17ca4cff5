#pragma once

#include "answer/diagnosis.h"
#include "search/effect_search.h"

#include <string>
#include <vector>

namespace lacuna {

/// Errors of predictions of one model, by length and channel: in the channel's unit the noise of a reading times the
/// root of the mean square of whitened residuals. NaN where nothing is read or the model cannot be simulated.
class ErrorsByLength {
 public:
  /// Of a set's values over all lengths of the search; held out too, where the task has such trials.
  ErrorsByLength(const SearchData& data, const FittedModel& set);

  bool is_read(std::size_t length, std::size_t channel) const;
  double fitted(std::size_t length, std::size_t channel) const { return error(fitted_, length, channel); }
  double held_out(std::size_t length, std::size_t channel) const { return error(held_out_, length, channel); }
  /// Root of the mean of whitened squares over all that are read, each length and joint as heavy as in the cost.
  double times_floor() const;
  /// Over the longest predictions of each channel.
  std::vector<ChannelError> longest() const;
  /// s, of the longest.
  double longest_length() const;

 private:
  double error(const Eigen::VectorXd& mean_squares, std::size_t length, std::size_t channel) const;

  const PredictionLadder& ladder_;
  Eigen::VectorXd fitted_, held_out_;  ///< mean squares by cell; empty: nothing
};

/// Side by side, every length and channel that is read.
std::vector<HorizonError> errors_by_horizon(const SearchData& data, const ErrorsByLength& base,
                                            const ErrorsByLength& answer);

}  // namespace lacuna
