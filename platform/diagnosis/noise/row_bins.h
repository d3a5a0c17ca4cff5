#pragma once

#include "fitting/shooting_problem.h"

#include <vector>

namespace lacuna {

/// Measured rows of a shooting problem, segment by segment, as means over short bins of time. What is slower than a bin
/// keeps its information, and a segment's covariance stays a small matrix.
class RowBins {
 public:
  struct Bin {
    std::size_t channel = 0;  ///< index into the noise list
    double time = 0.0;        ///< s, mean of its samples
    double count = 0.0;       ///< samples
  };

  /// `least_widths`: s, by channel of the noise list; empty: 12.5 ms for all.
  explicit RowBins(const ShootingProblem& problem, const std::vector<double>& least_widths = {});
  /// A row a bin.
  explicit RowBins(std::vector<std::vector<Bin>> segments);

  std::size_t segments() const { return segments_.size(); }
  const std::vector<Bin>& bins(std::size_t k) const { return segments_[k].bins; }
  Eigen::Index rows(std::size_t k) const { return static_cast<Eigen::Index>(segments_[k].bins.size()); }
  Eigen::Index rows() const;
  /// Of each bin of a segment: the number of its block, half a second by which predictions are judged. Times without
  /// bins have none.
  std::vector<std::size_t> blocks(std::size_t k) const;
  /// Bins × columns. `rows`: the problem's rows of segment `k`; those of priors, which come last, are left out.
  Eigen::MatrixXd means(std::size_t k, const Eigen::Ref<const Eigen::MatrixXd>& rows) const;

 private:
  struct Segment {
    std::vector<Bin> bins;
    std::vector<Eigen::Index> bin_of;  ///< a measured row
  };
  std::vector<Segment> segments_;
};

}  // namespace lacuna
