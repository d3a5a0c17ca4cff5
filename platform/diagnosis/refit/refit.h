#pragma once

#include "diagnosis/noise/base_solution.h"
#include "diagnosis/noise/robust_segment.h"
#include "diagnosis/refit/whitened_problem.h"

#include <optional>
#include <vector>

namespace lacuna {

/// A model fitted to the whitened segments, with what cross-validation needs of it.
struct Refit {
  bool valid = false;
  bool converged = false;
  std::vector<double> values;           ///< of the model's free values, SI
  std::vector<Eigen::VectorXd> states;  ///< of the segments' starts
  std::optional<double> timing;  ///< in command intervals, where the base's is fitted; its coordinate is the last
  double deviance = 0.0;         ///< Σ of the loss: −2 log likelihood but for a constant
  std::vector<RobustSegment> segments;
  std::vector<WeightedSegment> weighted;  ///< the same under the weights of the fit
  /// Residual and derivatives before whitening, bins alone, in multiples of the sensor noise; starts follow the values.
  std::vector<Eigen::VectorXd> bin_residuals;
  std::vector<Eigen::MatrixXd> bin_derivatives;
  std::vector<bool> at_bound;  ///< a value
  Eigen::MatrixXd covariance;  ///< of the coordinates; 0 for values at a bound
};

/// What is refitted.
struct RefittedModel {
  const ModelDefinition& definition;
  const CompiledModel& model;
  const std::vector<std::size_t>& base;  ///< where it has the base's free values
};

struct RefitEffort {
  double precision = 0.01;  ///< of the deviance: a step that lowers it by less is the last
  int iterations = 30;
};

/// A base whose segments start, and whose commands act, where a fit to it ended: for one that goes on.
BaseSolution from(BaseSolution base, const Refit& fit);

/// Minimises from the best of `starts` (free values, SI).
Refit refit(const RefittedModel& refitted, const BaseSolution& base, const RowBins& bins,
            const std::vector<Eigen::MatrixXd>& factors, const std::vector<std::vector<double>>& starts, int threads,
            RefitEffort effort = {});

}  // namespace lacuna
