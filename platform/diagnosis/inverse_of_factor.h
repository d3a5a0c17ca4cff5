#pragma once

#include <Eigen/Core>

namespace lacuna {

/// The lower half of (L·Lᵀ)⁻¹; what stands above the diagonal means nothing, neither in L. n × n; n³/3 multiplications
/// (LAPACK's potri, by halves), a third of those of solving for the identity.
Eigen::MatrixXd inverse_of_factor(const Eigen::MatrixXd& factor);

}  // namespace lacuna
