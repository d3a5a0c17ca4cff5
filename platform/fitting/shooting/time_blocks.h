#pragma once

#include "fitting/shooting/shooting_problem.h"

#include <map>

namespace lacuna {

/// Every trial's scored time in equal blocks of about `length` s, at least one per trial; numbered over all trials.
class TimeBlocks {
 public:
  TimeBlocks(const ShootingProblem& problem, double length);

  int count() const { return count_; }
  /// The block of a row of segment `k`; a prior belongs to the time of its state.
  int of(std::size_t k, Eigen::Index row) const;

 private:
  struct Span {
    double begin = 0.0, end = 0.0;
    int first = 0, blocks = 1;
  };
  const ShootingProblem& problem_;
  std::map<std::size_t, Span> spans_;  ///< by trial
  int count_ = 0;
};

/// Scored time of all trials together, s.
double scored_duration(const ShootingProblem& problem);

}  // namespace lacuna
