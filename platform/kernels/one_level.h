#pragma once

// The kernels, for the processors that the including source is compiled for. It defines `Eigen` as a name of its own
// before: inline functions of two levels must never be taken for each other by the linker.

#include "kernels/levels.h"

// For small products Eigen has a second way, which fuses multiplications with additions only where whole registers of
// the result fit, and thus rounds by where the result lies in memory.
#define EIGEN_GEMM_TO_COEFFBASED_THRESHOLD 1

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace lacuna {
namespace {

using Index = Eigen::Index;
using Stride = Eigen::OuterStride<>;
using Numbers = Eigen::Map<Eigen::MatrixXd, Eigen::Unaligned, Stride>;
using ReadNumbers = Eigen::Map<const Eigen::MatrixXd, Eigen::Unaligned, Stride>;
using Block = Eigen::Ref<Eigen::MatrixXd>;
using ReadBlock = Eigen::Ref<const Eigen::MatrixXd>;

constexpr Index kSmall = 32;  ///< rows that are not worth halving

bool is_empty(const DenseView& view) { return view.rows == 0 || view.columns == 0; }

Numbers numbers(const DenseView& view) { return {view.numbers, view.rows, view.columns, Stride(view.stride)}; }

ReadNumbers numbers(const DenseOperand& of) { return {of.numbers, of.rows, of.columns, Stride(of.stride)}; }

void add_product(double factor, const DenseOperand& a, const DenseOperand& b, const DenseView& sum) {
  Numbers result = numbers(sum);
  if (a.transposed && b.transposed)
    result.noalias() += factor * numbers(a).transpose() * numbers(b).transpose();
  else if (a.transposed)
    result.noalias() += factor * numbers(a).transpose() * numbers(b);
  else if (b.transposed)
    result.noalias() += factor * numbers(a) * numbers(b).transpose();
  else
    result.noalias() += factor * numbers(a) * numbers(b);
}

void add_square(double factor, const DenseOperand& a, const DenseView& sum) {
  if (a.rows == 0 || a.columns == 0) return;  // Eigen divides by either
  Numbers result = numbers(sum);
  auto half = result.selfadjointView<Eigen::Lower>();
  if (a.transposed)
    half.rankUpdate(numbers(a).transpose(), factor);
  else
    half.rankUpdate(numbers(a), factor);
}

/// Of [A .; B C]: A = L·Lᵀ, B = B·L⁻ᵀ, C = C − B·Bᵀ, and so on.
bool factorize_block(Block matrix) {
  const Index rows = matrix.rows(), half = (rows / 2 + 7) / 8 * 8;
  if (rows <= kSmall) return Eigen::internal::llt_inplace<double, Eigen::Lower>::unblocked(matrix) < 0;
  Block first = matrix.topLeftCorner(half, half), last = matrix.bottomRightCorner(rows - half, rows - half);
  Block mixed = matrix.bottomLeftCorner(rows - half, half);
  if (!factorize_block(first)) return false;
  first.transpose().triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(mixed);
  last.selfadjointView<Eigen::Lower>().rankUpdate(mixed, -1.0);
  return factorize_block(last);
}

bool factorize(const DenseView& matrix) { return is_empty(matrix) || factorize_block(numbers(matrix)); }

void solve(const DenseOperand& lower, const DenseView& solution) {
  if (is_empty(solution)) return;
  Numbers result = numbers(solution);
  if (lower.transposed)
    numbers(lower).transpose().triangularView<Eigen::Upper>().solveInPlace(result);
  else
    numbers(lower).triangularView<Eigen::Lower>().solveInPlace(result);
}

void solve_from_right(const DenseOperand& lower, const DenseView& solution) {
  if (is_empty(solution)) return;
  Numbers result = numbers(solution);
  if (lower.transposed)
    numbers(lower).transpose().triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(result);
  else
    numbers(lower).triangularView<Eigen::Lower>().solveInPlace<Eigen::OnTheRight>(result);
}

/// Of [A 0; B C]: [A⁻¹ 0; −C⁻¹·B·A⁻¹ C⁻¹], in place.
void invert_lower(Block matrix) {
  const Index rows = matrix.rows(), half = rows / 2;
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
  const Index rows = matrix.rows(), half = rows / 2;
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

void invert_square(const DenseView& lower) {
  if (is_empty(lower)) return;
  invert_lower(numbers(lower));
  square_lower(numbers(lower));
}

bool find_eigenvectors(const DenseView& matrix, double* eigenvalues) {
  if (is_empty(matrix)) return true;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(numbers(matrix));
  Eigen::Map<Eigen::VectorXd>(eigenvalues, matrix.rows) = eigen.eigenvalues();
  numbers(matrix) = eigen.eigenvectors();
  return eigen.info() == Eigen::Success;
}

using ReadColumn = Eigen::Map<const Eigen::VectorXd>;

/// Of a column, what stands on and below the diagonal.
ReadColumn below(const double* matrix, Index rows, Index column) {
  return {matrix + column * rows + column, rows - column};
}

void sum_lower(const double* const* terms, const DenseOperand& factors, const DenseView& sum) {
  const Index count = factors.columns;
  for (Index column = 0; column < sum.columns; ++column) {
    Eigen::Map<Eigen::VectorXd> result(sum.numbers + column * sum.stride + column, sum.rows - column);
    const auto term = [&](Index i) {
      return factors.numbers[i * factors.stride + column] * below(terms[i], sum.rows, column);
    };
    Index i = std::min<Index>(count, 3);
    if (i == 3)
      result = term(0) + term(1) + term(2);
    else if (i == 2)
      result = term(0) + term(1);
    else if (i == 1)
      result = term(0);
    else
      result.setZero();
    for (; i + 2 <= count; i += 2) result += term(i) + term(i + 1);
    if (i < count) result += term(i);
  }
}

void trace_products(const DenseOperand& weights, const double* const* terms, const DenseView& traces) {
  for (Index column = 0; column < weights.columns; ++column) {
    const ReadColumn weight(weights.numbers + column * weights.stride + column, weights.rows - column);
    for (Index i = 0; i < traces.columns; ++i) {
      const ReadColumn term = below(terms[i], weights.rows, column);
      traces.numbers[i * traces.stride + column] = 2.0 * weight.dot(term) - weight(0) * term(0);
    }
  }
}

constexpr DenseKernels kernels_of(const char* level) {
  return {level,         add_product,       add_square, factorize,     solve, solve_from_right,
          invert_square, find_eigenvectors, sum_lower,  trace_products};
}

}  // namespace
}  // namespace lacuna
