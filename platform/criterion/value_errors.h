#pragma once

#include "criterion/cost.h"

#include <Eigen/Core>

namespace lacuna {

/// How well the data tell the values of a fitted model, in its coordinates.
struct ValueErrors {
  Eigen::MatrixXd covariance;  ///< zero in the directions that the data do not tell
  std::vector<bool> is_told;   ///< by value: false where some direction that moves it is not told
  Eigen::VectorXd standard() const { return covariance.diagonal().cwiseMax(0.0).cwiseSqrt(); }
};

/// Standard errors that do not believe the noise model: the scatter of the gradients of the cost over blocks of time,
/// all lengths together, taken once, twice and four times as long, between two inverse informations (the "sandwich"
/// of P. J. Huber, 1967, and H. White, 1982); of the three the largest, value by value. `fit`: the least cost; `ridge`:
/// with which it was found (`StepBounds`).
ValueErrors value_errors(const CellLayout& layout, const BlockProducts& products, const LinearCost& fit,
                         const Eigen::VectorXd& ridge = {});

}  // namespace lacuna
