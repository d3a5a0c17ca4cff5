#pragma once

#include "evaluation/model/model_definition.h"

#include <Eigen/Core>

#include <vector>

namespace lacuna {

/// Coordinates in which the search moves: the logarithm of a value that is declared logarithmic and stays positive, the
/// value itself otherwise; always within its bounds.
class ParameterSpace {
 public:
  explicit ParameterSpace(const std::vector<FreeValue>& free);

  Eigen::Index size() const { return lower_.size(); }
  const Eigen::VectorXd& lower() const { return lower_; }
  const Eigen::VectorXd& upper() const { return upper_; }
  const Eigen::VectorXd& start() const { return start_; }
  bool logarithmic(Eigen::Index j) const { return logarithmic_[static_cast<std::size_t>(j)]; }

  double to_coordinate(Eigen::Index j, double value) const;
  double to_value(Eigen::Index j, double coordinate) const;
  std::vector<double> to_values(const Eigen::VectorXd& coordinates) const;
  Eigen::VectorXd to_coordinates(const std::vector<double>& values) const;
  /// d value / d coordinate.
  double slope(Eigen::Index j, double coordinate) const;
  Eigen::VectorXd clamp(const Eigen::VectorXd& coordinates) const {
    return coordinates.cwiseMax(lower_).cwiseMin(upper_);
  }

 private:
  std::vector<bool> logarithmic_;
  Eigen::VectorXd lower_, upper_, start_;  ///< in coordinates
};

}  // namespace lacuna
