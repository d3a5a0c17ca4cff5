#pragma once

#include "answer/diagnosis.h"
#include "search/effect_search.h"

#include <optional>
#include <vector>

namespace lacuna {

/// The values of a fitted set with their 95 % intervals: sandwich covariance over blocks of time and all lengths
/// together (criterion/value_errors.h). A value at its bound, or one that these data do not determine, has no interval.
class FittedValues {
 public:
  FittedValues(const SearchResult& found, const FittedModel& set);

  std::vector<FoundEffect> effects() const;
  /// The model's own values, by address.
  std::vector<FoundParameter> own() const;

  /// Of the model alone, SI.
  std::vector<double> values() const;
  /// Timestamp offset in command intervals; nothing where it was not fitted.
  std::optional<double> timing() const;
  bool timing_is_told() const;
  /// Covariance of the coordinates, the timestamp offset last; 0 for a value without an interval.
  const Eigen::MatrixXd& covariance() const { return covariance_; }

 private:
  bool is_at_bound(Eigen::Index value) const;
  FoundParameter parameter(std::size_t value, const std::string& name) const;

  const FittedModel& set_;
  bool timing_;
  ParameterSpace space_;
  Eigen::MatrixXd covariance_;
};

}  // namespace lacuna
