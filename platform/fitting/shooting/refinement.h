#pragma once

#include "fitting/shooting/shooting_problem.h"

#include <functional>
#include <vector>

namespace lacuna {

/// A start and where the search has led from it in one stage.
struct Candidate {
  Eigen::VectorXd values;  ///< coordinates; the start, then the result
  bool valid = false;
  LeastSquaresResult search;
  std::vector<double> scales;  ///< of the channels, under which `search` ended
  std::vector<double> steps;   ///< of differences, as the search left them
  double objective = 0.0;      ///< what candidates are compared by: Σ 2 log scale + bounded loss (see .cpp)
  std::size_t samples = 0;     ///< measured values that `objective` sums over
  double residual = 0.0;       ///< RMS of residual over sensor noise
};

/// By how many units of −2 log likelihood a search may miss its minimum: a tenth of a standard error at the end, a
/// third on the way, a whole one to tell minima apart.
inline constexpr double kFine = 0.01, kMiddling = 0.1, kCoarse = 1.0;

struct RefinementOptions {
  RobustLoss loss;
  int max_iterations = 50;
  double precision = kFine;  ///< of minus twice the log likelihood (correlation minded), where the search may stop
  std::function<void(int)> progress = {};
  /// Of `refine`: called with each better point; by several threads where several starts are refined.
  std::function<void(const FitPoint&)> reached = {};
};

/// Minimises from `values`, start states at their guesses. Residuals are weighed by a scale a channel that
/// follows the residual itself (median absolute deviation, at least the sensor noise), so that a model that is
/// still wrong is not fitted as if all of its error were outliers.
Candidate refine(ShootingProblem& problem, const Eigen::VectorXd& values, const RefinementOptions& options);

/// What `refine` would make of values that may not move: only start states are fitted. Its objective is that of the
/// values alone, where the problem's segments were made with them.
Candidate evaluate(ShootingProblem& problem, const Eigen::VectorXd& values, const RefinementOptions& options);

std::vector<Eigen::VectorXd> starts_of(const std::vector<Candidate>& candidates);

/// Sorts by objective, those that are not valid last. Returns how many reached the best one's error.
int rank(std::vector<Candidate>& candidates, std::size_t samples);

inline constexpr int kRivals = 2;

/// Keeps the best and the best of those that ended elsewhere: another stage may turn their order round.
void keep_rivals(std::vector<Candidate>& candidates, std::size_t samples);

}  // namespace lacuna
