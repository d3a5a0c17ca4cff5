#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace lacuna {

/// Least squares of several targets on the same regressors, with sums of products kept per block, so that a fit without
/// one block costs no second pass. The first regressor should be 1.
///
/// Noise of the regressors would reduce their coefficients and favour regressors with little noise. So each row is
/// given twice, with two measurements of the regressors whose noises are independent: products of one with the other
/// have no noise on average. Giving the same row twice is ordinary least squares.
class BlockedRegression {
 public:
  BlockedRegression(Eigen::Index regressors, Eigen::Index targets, std::size_t blocks);

  /// Regressors, then targets, which are the same in both.
  void add(std::size_t block, const Eigen::VectorXd& row, const Eigen::VectorXd& again);

  std::size_t blocks() const { return products_.size(); }
  double rows() const { return total_(0, 0); }
  double rows(std::size_t block) const { return products_[block](0, 0); }
  /// Variance of a target per row, about its mean.
  double variance(Eigen::Index target) const;
  /// The share of that variance which the regressors leave unexplained: over all blocks, without one, and in one alone.
  /// May be a little below zero. NaN where the target does not vary, or the regressors are hardly more than noise.
  double unexplained(Eigen::Index target) const { return unexplained_of(total_, target); }
  double unexplained_without(std::size_t block, Eigen::Index target) const {
    return unexplained_of(total_ - products_[block], target);
  }
  double unexplained_in(std::size_t block, Eigen::Index target) const {
    return unexplained_of(products_[block], target);
  }
  /// Mean squared error in each block of the fit to all blocks; may be a little below zero. Empty where nothing could
  /// be fitted.
  std::vector<double> errors(Eigen::Index target) const;

 private:
  double unexplained_of(const Eigen::MatrixXd& products, Eigen::Index target) const;
  std::optional<Eigen::VectorXd> coefficients(const Eigen::MatrixXd& products, Eigen::Index target) const;

  Eigen::Index regressors_;
  std::vector<Eigen::MatrixXd> products_;
  Eigen::MatrixXd total_;
};

}  // namespace lacuna
