#pragma once

#include "kernels/kernels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace lacuna::test {

/// Sizes that no vector width divides, and those that all do.
inline const std::vector<std::ptrdiff_t> kSizes = {0, 1, 2, 3, 5, 8, 17, 31, 33, 64, 67, 131};

/// A matrix with unused numbers below each column. They are not numbers: who reads them spoils a result, who writes
/// them is seen.
class Strided {
 public:
  Strided(std::ptrdiff_t rows, std::ptrdiff_t columns, std::ptrdiff_t gap = 3)
      : rows_(rows), columns_(columns), stride_(rows + gap), numbers_(size(), kNothing) {}

  static Strided random(std::ptrdiff_t rows, std::ptrdiff_t columns, std::mt19937_64& source, std::ptrdiff_t gap = 3) {
    Strided matrix(rows, columns, gap);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (std::ptrdiff_t column = 0; column < columns; ++column)
      for (std::ptrdiff_t row = 0; row < rows; ++row) matrix(row, column) = uniform(source);
    return matrix;
  }

  std::ptrdiff_t rows() const { return rows_; }
  std::ptrdiff_t columns() const { return columns_; }
  double& operator()(std::ptrdiff_t row, std::ptrdiff_t column) { return numbers_[place(row, column)]; }
  double operator()(std::ptrdiff_t row, std::ptrdiff_t column) const { return numbers_[place(row, column)]; }
  const double* numbers() const { return numbers_.data(); }

  DenseView view() { return {numbers_.data(), rows_, columns_, stride_}; }
  DenseOperand operand(bool transposed = false) const {
    return {numbers_.data(), rows_, columns_, stride_, transposed};
  }

  void forget_above_diagonal() {
    for (std::ptrdiff_t column = 0; column < columns_; ++column)
      for (std::ptrdiff_t row = 0; row < std::min(column, rows_); ++row) (*this)(row, column) = kNothing;
  }
  bool gaps_are_untouched() const {
    for (std::ptrdiff_t column = 0; column < columns_; ++column)
      for (std::ptrdiff_t row = rows_; row < stride_; ++row)
        if (!std::isnan((*this)(row, column))) return false;
    return true;
  }
  bool is_untouched_above_diagonal() const {
    for (std::ptrdiff_t column = 0; column < columns_; ++column)
      for (std::ptrdiff_t row = 0; row < std::min(column, rows_); ++row)
        if (!std::isnan((*this)(row, column))) return false;
    return true;
  }

 private:
  static constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  std::size_t size() const { return static_cast<std::size_t>(stride_ * columns_); }
  std::size_t place(std::ptrdiff_t row, std::ptrdiff_t column) const {
    return static_cast<std::size_t>(column * stride_ + row);
  }

  std::ptrdiff_t rows_, columns_, stride_;
  std::vector<double> numbers_;
};

/// Σ a(i, k) · b(k, j) by plain loops, and the same of absolute values, which rounding is measured by.
struct PlainSum {
  long double value = 0.0L, size = 0.0L;

  void add(double a, double b) {
    value += static_cast<long double>(a) * b;
    size += std::abs(static_cast<long double>(a) * b);
  }
};

/// What rounding may do to a sum of `count` products, in any order.
inline double rounding(std::ptrdiff_t count, long double size) {
  return 2.0 * static_cast<double>(count + 4) * std::numeric_limits<double>::epsilon() * static_cast<double>(size);
}

/// A test of every level that this processor has.
class OfEachLevel : public testing::TestWithParam<const DenseKernels*> {
 protected:
  const DenseKernels& kernels() const { return *GetParam(); }
  std::ptrdiff_t any_size() {
    return kSizes[std::uniform_int_distribution<std::size_t>(0, kSizes.size() - 1)(random_)];
  }
  bool any_bool() { return std::bernoulli_distribution(0.5)(random_); }

  std::mt19937_64 random_{7};
};

inline std::string level_name(const testing::TestParamInfo<const DenseKernels*>& info) {
  std::string name = info.param->level;
  for (char& one : name)
    if (one == '-') one = '_';
  return name;
}

}  // namespace lacuna::test
