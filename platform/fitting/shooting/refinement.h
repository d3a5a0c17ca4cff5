#pragma once

#include "fitting/shooting/shooting_problem.h"

#include <functional>
#include <vector>

namespace lacuna {

/// A start and the result of the search from it in one stage.
struct Candidate {
  Eigen::VectorXd values;  ///< coordinates; the start, then the result
  bool valid = false;
  LeastSquaresResult search;
  std::vector<double> scales;  ///< of the channels, at the end of `search`
  std::vector<double> steps;   ///< of differences, at the end of the search
  double objective = 0.0;      ///< measure by which candidates are compared: Σ 2 log scale + bounded loss (see .cpp)
  std::size_t samples = 0;     ///< measured values that `objective` sums over
  double residual = 0.0;       ///< RMS of residual over sensor noise
};

/// Units of −2 log likelihood by which a search may miss its minimum: a tenth of a standard error at the end, a third
/// on the way, a whole one to distinguish minima.
inline constexpr double kFine = 0.01, kMiddling = 0.1, kCoarse = 1.0;

struct RefinementOptions {
  RobustLoss loss;
  int max_iterations = 50;
  double precision = kFine;  ///< of −2 log likelihood (for correlated residuals), where the search may stop
  std::function<void(int)> progress = {};
  /// Of `refine`: called with each better point; by several threads where several starts are refined.
  std::function<void(const FitPoint&)> reached = {};
};

/// Minimises from `values`, with initial states at their guesses. Residuals are weighted by one scale per channel that
/// follows the residual (median absolute deviation, at least the sensor noise), so that a wrong model is not fitted as
/// if all of its error were outliers.
Candidate refine(ShootingProblem& problem, const Eigen::VectorXd& values, const RefinementOptions& options);

/// The result of `refine` for values that are held: only initial states are fitted. The objective depends only on the
/// values where the problem's segments were made with them.
Candidate evaluate(ShootingProblem& problem, const Eigen::VectorXd& values, const RefinementOptions& options);

std::vector<Eigen::VectorXd> starts_of(const std::vector<Candidate>& candidates);

/// Sorts by objective, those that are not valid last. Returns how many reached the best one's error.
int rank(std::vector<Candidate>& candidates, std::size_t samples);

inline constexpr int kKeptCandidates = 2;

/// Keeps the best and the best of those with other minima: another stage may change their order.
void keep_best(std::vector<Candidate>& candidates, std::size_t samples);

}  // namespace lacuna
