#pragma once

#include "answer/diagnosis.h"
#include "search/effect_search.h"

#include <optional>
#include <vector>

namespace lacuna {

/// The values of a fitted set with their 95 % intervals: sandwich over blocks of time and all lengths together
/// (criterion/value_errors.h). A value at its bound, or one that the data do not tell, has none.
class FittedValues {
 public:
  FittedValues(const SearchResult& found, const FittedModel& set);

  std::vector<FoundEffect> effects() const;
  /// The model's own, by address.
  std::vector<FoundParameter> own() const;

  /// Of the model alone, SI.
  std::vector<double> values() const;
  /// Command intervals; nothing where it was not fitted.
  std::optional<double> timing() const;
  bool timing_is_told() const;
  /// Of the coordinates, the timing's last; 0 for what has no interval.
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
