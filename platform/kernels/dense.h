#pragma once

#include "kernels/kernels.h"

#include <Eigen/Core>

#include <type_traits>
#include <utility>
#include <vector>

/// The dense kernels for matrices of Eigen. Operands are matrices, vectors, blocks of them, or transposes of these;
/// nothing is copied. What is no more than an expression must be evaluated before.
namespace lacuna::dense {

template <class Matrix>
DenseView view(Matrix&& matrix) {
  using Type = std::decay_t<Matrix>;
  static_assert(!Type::IsRowMajor && Type::InnerStrideAtCompileTime == 1, "results are stored by columns");
  return {matrix.data(), matrix.rows(), matrix.cols(), matrix.outerStride()};
}

template <class Matrix>
DenseOperand operand(const Eigen::MatrixBase<Matrix>& matrix) {
  static_assert(Matrix::InnerStrideAtCompileTime == 1, "a column's or a row's numbers must stand beside each other");
  const Matrix& stored = matrix.derived();
  if constexpr (Matrix::IsRowMajor) return {stored.data(), stored.cols(), stored.rows(), stored.outerStride(), true};
  return {stored.data(), stored.rows(), stored.cols(), stored.outerStride(), false};
}

/// sum += factor · a · b
template <class A, class B, class Sum>
void add_product(double factor, const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b, Sum&& sum) {
  dense_kernels().add_product(factor, operand(a), operand(b), view(sum));
}

template <class A, class B>
Eigen::MatrixXd product(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(a.rows(), b.cols());
  add_product(1.0, a, b, result);
  return result;
}

/// Lower half of sum += factor · a · aᵀ
template <class A, class Sum>
void add_square(double factor, const Eigen::MatrixBase<A>& a, Sum&& sum) {
  dense_kernels().add_square(factor, operand(a), view(sum));
}

/// a · aᵀ
template <class A>
Eigen::MatrixXd square(const Eigen::MatrixBase<A>& a) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(a.rows(), a.rows());
  add_square(1.0, a, result);
  result.triangularView<Eigen::StrictlyUpper>() = result.transpose();
  return result;
}

/// The lower Cholesky factor L of a symmetric matrix.
class Cholesky {
 public:
  Cholesky() = default;
  /// Reads the lower half.
  explicit Cholesky(Eigen::MatrixXd matrix)
      : lower_(std::move(matrix)), exists_(dense_kernels().factorize(view(lower_))) {}

  /// False: the matrix is not positive definite.
  bool exists() const { return exists_; }
  /// What stands above the diagonal means nothing.
  const Eigen::MatrixXd& lower() const { return lower_; }
  double log_determinant() const { return 2.0 * lower_.diagonal().array().log().sum(); }

  /// solution = L⁻¹ · solution
  template <class Solution>
  void solve_lower(Solution&& solution) const {
    dense_kernels().solve(operand(lower_), view(solution));
  }
  /// solution = L⁻ᵀ · solution
  template <class Solution>
  void solve_upper(Solution&& solution) const {
    dense_kernels().solve(operand(lower_.transpose()), view(solution));
  }
  /// solution = solution · L⁻ᵀ
  template <class Solution>
  void solve_from_right(Solution&& solution) const {
    dense_kernels().solve_from_right(operand(lower_.transpose()), view(solution));
  }
  /// The same with zeros above the diagonal.
  Eigen::MatrixXd triangle() const { return lower_.triangularView<Eigen::Lower>(); }
  /// The factor, which is gone then.
  Eigen::MatrixXd take() {
    exists_ = false;
    return std::move(lower_);
  }

 private:
  Eigen::MatrixXd lower_;
  bool exists_ = false;
};

/// Eigenvalues of a symmetric matrix in rising order, and its eigenvectors in columns.
struct Eigenvectors {
  /// Reads the lower half.
  explicit Eigenvectors(Eigen::MatrixXd matrix) : vectors(std::move(matrix)), values(vectors.rows()) {
    dense_kernels().find_eigenvectors(view(vectors), values.data());
  }

  Eigen::MatrixXd vectors;
  Eigen::VectorXd values;
};

/// Lower half of sum = Σ terms[i] · diag(factors.col(i)); each term is stored as `sum` is, without gaps.
inline void sum_lower(const std::vector<const double*>& terms, const Eigen::MatrixXd& factors, Eigen::MatrixXd& sum) {
  dense_kernels().sum_lower(terms.data(), operand(factors.leftCols(static_cast<Eigen::Index>(terms.size()))),
                            view(sum));
}

/// tr(weights · terms[i]) of symmetric matrices, of which the lower halves are read, as sums over column i of the
/// result: what each column of the matrices gives.
inline Eigen::MatrixXd trace_products(const Eigen::MatrixXd& weights, const std::vector<const double*>& terms) {
  Eigen::MatrixXd traces(weights.cols(), static_cast<Eigen::Index>(terms.size()));
  dense_kernels().trace_products(operand(weights), terms.data(), view(traces));
  return traces;
}

/// Lower half of L becomes the lower half of (L·Lᵀ)⁻¹; what stands above the diagonal is lost.
inline void invert_square(Eigen::MatrixXd& lower) { dense_kernels().invert_square(view(lower)); }

/// solution = L⁻¹ · solution of a lower triangular L; above its diagonal nothing is read.
template <class Lower, class Solution>
void solve_lower(const Eigen::MatrixBase<Lower>& lower, Solution&& solution) {
  dense_kernels().solve(operand(lower), view(solution));
}

}  // namespace lacuna::dense
