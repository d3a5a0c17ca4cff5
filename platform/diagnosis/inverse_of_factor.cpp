#include "diagnosis/inverse_of_factor.h"

namespace lacuna {
namespace {

using Block = Eigen::Ref<Eigen::MatrixXd>;

constexpr Eigen::Index kSmall = 32;  ///< rows that are not worth halving

/// Of [A 0; B C]: [A⁻¹ 0; −C⁻¹·B·A⁻¹ C⁻¹], in place.
void invert_lower(Block matrix) {
  const Eigen::Index rows = matrix.rows(), half = rows / 2;
  if (rows <= kSmall) {
    matrix = Eigen::MatrixXd(matrix.triangularView<Eigen::Lower>().solve(Eigen::MatrixXd::Identity(rows, rows)));
    return;
  }
  Block first = matrix.topLeftCorner(half, half), last = matrix.bottomRightCorner(rows - half, rows - half);
  Block mixed = matrix.bottomLeftCorner(rows - half, half);
  invert_lower(first);
  invert_lower(last);
  const Eigen::MatrixXd right = mixed * first.triangularView<Eigen::Lower>();
  mixed = -(last.triangularView<Eigen::Lower>() * right);
}

/// The lower half of XᵀX of a lower triangular X = [A 0; B C], in place: [AᵀA + BᵀB .; CᵀB CᵀC].
void square_lower(Block matrix) {
  const Eigen::Index rows = matrix.rows(), half = rows / 2;
  if (rows <= kSmall) {
    const Eigen::MatrixXd lower = matrix.triangularView<Eigen::Lower>();
    matrix.triangularView<Eigen::Lower>() = lower.transpose() * lower;
    return;
  }
  Block first = matrix.topLeftCorner(half, half), last = matrix.bottomRightCorner(rows - half, rows - half);
  Block mixed = matrix.bottomLeftCorner(rows - half, half);
  square_lower(first);
  first.selfadjointView<Eigen::Lower>().rankUpdate(mixed.transpose());
  mixed = Eigen::MatrixXd(last.transpose().triangularView<Eigen::Upper>() * mixed);
  square_lower(last);
}

}  // namespace

Eigen::MatrixXd inverse_of_factor(const Eigen::MatrixXd& factor) {
  Eigen::MatrixXd inverse = factor;
  invert_lower(inverse);
  square_lower(inverse);
  return inverse;
}

}  // namespace lacuna
