#pragma once

#include <cstddef>
#include <vector>

namespace lacuna {

/// A matrix that is stored by columns, which begin `stride` numbers apart.
struct DenseView {
  double* numbers = nullptr;
  std::ptrdiff_t rows = 0, columns = 0, stride = 0;
};

/// A matrix that is only read; `transposed`: its transpose is meant. The other members describe it as it is stored.
struct DenseOperand {
  const double* numbers = nullptr;
  std::ptrdiff_t rows = 0, columns = 0, stride = 0;
  bool transposed = false;
};

/// Dense linear algebra on pointers and sizes, compiled for one level of processors. Each function works in the calling
/// thread alone. Sizes must fit, and results must not overlap operands. Digits differ between levels by rounding.
struct DenseKernels {
  const char* level = "";  ///< as `LACUNA_KERNELS` names it

  /// sum += factor · a · b
  void (*add_product)(double factor, const DenseOperand& a, const DenseOperand& b, const DenseView& sum);
  /// Lower half of sum += factor · a · aᵀ
  void (*add_square)(double factor, const DenseOperand& a, const DenseView& sum);
  /// Lower half of a symmetric matrix becomes its Cholesky factor. False: the matrix is not positive definite, and its
  /// content is lost. What stands above the diagonal is neither read nor written.
  bool (*factorize)(const DenseView& matrix);
  /// solution = L⁻¹ · solution, or L⁻ᵀ · solution where `lower` is transposed. Above the diagonal nothing is read.
  void (*solve)(const DenseOperand& lower, const DenseView& solution);
  /// solution = solution · L⁻¹, or solution · L⁻ᵀ where `lower` is transposed.
  void (*solve_from_right)(const DenseOperand& lower, const DenseView& solution);
  /// Lower half of L becomes the lower half of (L·Lᵀ)⁻¹ (LAPACK's potri, by halves). What stands above the diagonal is
  /// lost.
  void (*invert_square)(const DenseView& lower);
  /// Eigenvalues of a symmetric matrix in rising order; the matrix becomes its eigenvectors. Reads the lower half.
  /// False: no convergence.
  bool (*find_eigenvectors)(const DenseView& matrix, double* eigenvalues);
  /// Lower half of sum = Σ terms[i] · diag(column i of factors). The terms, as many as factors has columns, are stored
  /// as `sum` is, without gaps; of each the lower half is read.
  void (*sum_lower)(const double* const* terms, const DenseOperand& factors, const DenseView& sum);
  /// tr(weights · terms[i]) of symmetric matrices, of which the lower halves are read, is the sum over column i of
  /// `traces`: a column of the matrices gives a row of it. The terms are stored without gaps.
  void (*trace_products)(const DenseOperand& weights, const double* const* terms, const DenseView& traces);
};

/// The kernels of the best level that this processor has, or of the one that the environment variable `LACUNA_KERNELS`
/// names; chosen at the first call. Throws `BadInput` if it names none that this processor has.
const DenseKernels& dense_kernels();

/// Those that this processor has, the portable ones first.
std::vector<const DenseKernels*> supported_kernels();

/// What `dense_kernels` chooses; `wanted`: content of `LACUNA_KERNELS`, null: not set.
const DenseKernels& choose_kernels(const char* wanted);

}  // namespace lacuna
