#pragma once

#include "baselines/candidate.h"

namespace hidden_effects {

/// The balance of all trials as one column of a linear regression: smoothed at the motions' cutoff, thinned to
/// what that filter lets through, the ends of each trial left out.
class Regression {
 public:
  Regression(const Observed& seen, const RecordedMotions& motions) : seen_(seen), motions_(motions) {}

  /// Rows: trials, in each its joints, one below the other; empty where there is no balance.
  Eigen::VectorXd column(const PlantModel& model, const Eigen::VectorXd& values) const;

  /// The base's values by which its balance is best, from those that it is written with.
  Eigen::VectorXd fitted_base() const;

  /// What the base's values do to the balance, one column each.
  Eigen::MatrixXd of_base(const Eigen::VectorXd& values) const;

  /// What a candidate does to it: its parameters' derivatives where they stand at `tried`, and its whole share there.
  /// No columns where the candidate has no regressor.
  Eigen::MatrixXd of_candidate(const Candidate& candidate, const Try& tried, const Eigen::VectorXd& values) const;

  /// Which joint each row belongs to.
  std::vector<std::size_t> joint_of_row() const;

 private:
  std::size_t thinning(std::size_t trial) const;
  std::vector<std::size_t> kept(std::size_t trial) const;

  const Observed& seen_;
  const RecordedMotions& motions_;
};

}  // namespace hidden_effects
