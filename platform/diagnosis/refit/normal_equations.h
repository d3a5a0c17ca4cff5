#pragma once

#include "diagnosis/noise/robust_segment.h"

#include <vector>

namespace lacuna {

/// Normal equations of the values: half the second derivative of the deviance by them, and half the first.
struct NormalEquations {
  Eigen::MatrixXd gram;
  Eigen::VectorXd score;

  void add(const WeightedSegment& segment);
  void add(const NormalEquations& other);
};

NormalEquations no_equations(Eigen::Index values);
NormalEquations normal_equations(const std::vector<WeightedSegment>& segments, Eigen::Index values);

/// By how much the deviance grows, to second order, where values move by `way` (one each of `moved`) and `others` are
/// fitted again. What the data tell little of grows little.
double cost_of_moving(const NormalEquations& equations, const std::vector<Eigen::Index>& moved,
                      const Eigen::VectorXd& way, const std::vector<Eigen::Index>& others);

}  // namespace lacuna
