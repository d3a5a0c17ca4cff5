#pragma once

#include "criterion/block_products.h"

#include <Eigen/Core>

namespace lacuna {

/// Of the largest eigenvalue of the scaled information: below, the data do not tell a direction of the values.
inline constexpr double kUntold = 1e-6;

/// The cost of a mean square m of whitened residuals, nats: ½ ln m above 1, where the scale of the error is free;
/// below, ½ (m − 1), the likelihood of a known variance. Both meet with one slope.
double cost_of_mean_square(double mean_square);

/// How far a model's values may move from where it was linearised, in their coordinates; zero lies between.
struct StepBounds {
  Eigen::VectorXd lower, upper;
  Eigen::VectorXd ridge = {};  ///< by value, of the diagonal of the normal equations; empty: none
  Eigen::VectorXd home = {};   ///< where values belong that the data hardly tell; empty: anywhere
  Eigen::VectorXd pull = {};   ///< by value, nats of a unit's way from home, squared; as long as `home`

  /// What the way from home costs, nats.
  double cost_of_way(const Eigen::VectorXd& step) const {
    return home.size() == 0 ? 0.0 : pull.dot((step - home).cwiseAbs2());
  }
};

/// A step of a linearised model's values, and what it leaves.
struct LinearCost {
  Eigen::VectorXd step;
  Eigen::VectorXd mean_square;  ///< by cell
  double cost = 0.0;            ///< nats, weighted mean over cells
};

LinearCost cost_at(const CellLayout& layout, const BlockProducts& products, const Eigen::VectorXd& step);

/// The step within bounds that costs least, to first order: weighted least squares, each cell's weight over the mean
/// square that is left of it, again and again. `damping`: of the diagonal of the normal equations, for a shorter step
/// (K. Levenberg, 1944; D. Marquardt, 1963).
LinearCost least_cost(const CellLayout& layout, const BlockProducts& products, const StepBounds& bounds,
                      double damping = 0.0);

/// What each block of time adds to a cost that sums to `cost`, by length: predicted with the values that the other
/// folds alone would have.
struct CrossFittedCost {
  Eigen::MatrixXd by_length;  ///< lengths × blocks, nats
  double cost = 0.0;

  Eigen::VectorXd by_block() const { return by_length.colwise().sum(); }
};

/// `fit`: the least cost of the whole, whose weights every fold takes. Values move by how much the step of the other
/// folds differs from that of all, so that a fit which is not at its least cost gains nothing by it. The other folds
/// are joined by a tenth of the whole's weight: where they hardly tell a value, it stays. `whole_steps`: values move by
/// all of the other folds' step, as those of a law do that begins at nothing, and nothing is joined: of what the others
/// do not tell nothing is taken.
CrossFittedCost cross_fit(const CellLayout& layout, const BlockProducts& products, const StepBounds& bounds,
                          const LinearCost& fit, bool whole_steps = false);

/// By cell, the weight of a square in the cost's slope at these mean squares.
Eigen::VectorXd square_weights(const CellLayout& layout, const BlockProducts& products, const Eigen::VectorXd& means);

/// Normal equations of the values under these weights: what the data tell of them.
Eigen::MatrixXd information(const CellLayout& layout, const BlockProducts& products, const LinearCost& fit);

/// How many of the values the data tell: the rank of the information in scaled coordinates.
int told_values(const Eigen::MatrixXd& information);

}  // namespace lacuna
