#pragma once

#include "diagnosis/noise/noise_model.h"
#include "diagnosis/refit/refit.h"
#include "diagnosis/refit/whitened_problem.h"

#include <vector>

namespace lacuna::test {

/// The refit of a model that is linear in its values and starts: where the loss is least.
inline Refit linear_refit(const NoiseModel& noise, const std::vector<LinearSegment>& linear) {
  const std::vector<Eigen::MatrixXd> factors = noise_factors(noise);
  const Eigen::Index values = linear.front().values.cols();
  Refit fit;
  fit.valid = true;
  fit.at_bound.assign(static_cast<std::size_t>(values), false);
  for (std::size_t k = 0; k < linear.size(); ++k) {
    const Eigen::Index bins = linear[k].residual.size(), states = linear[k].state.cols();
    const auto factor = factors[k].triangularView<Eigen::Lower>();
    RobustSegment segment{Eigen::VectorXd::Zero(bins + states), Eigen::MatrixXd::Zero(bins + states, values),
                          Eigen::MatrixXd::Identity(bins + states, states),
                          std::vector<std::size_t>(static_cast<std::size_t>(bins), 0)};
    segment.residual.head(bins) = factor.solve(linear[k].residual);
    segment.values.topRows(bins) = factor.solve(linear[k].values);
    segment.state.topRows(bins) = factor.solve(linear[k].state);
    segment.state.bottomRows(states) = Eigen::MatrixXd::Identity(states, states);
    fit.segments.push_back(std::move(segment));
  }
  for (int step = 0; step < 100; ++step) {
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(values, values);
    Eigen::VectorXd score = Eigen::VectorXd::Zero(values);
    fit.weighted.clear();
    for (RobustSegment& segment : fit.segments) {
      segment.residual = at_best_start(segment, segment.residual);
      fit.weighted.push_back(weighted(segment, segment.weights(segment.residual)));
      information += fit.weighted.back().values.transpose() * fit.weighted.back().values;
      score += fit.weighted.back().values.transpose() * fit.weighted.back().residual;
    }
    fit.covariance = information.inverse();
    for (RobustSegment& segment : fit.segments) segment.residual -= segment.values * (fit.covariance * score);
  }
  return fit;
}

}  // namespace lacuna::test
