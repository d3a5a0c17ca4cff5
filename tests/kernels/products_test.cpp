#include "kernels/strided.h"

namespace lacuna::test {
namespace {

class Products : public OfEachLevel {};

INSTANTIATE_TEST_SUITE_P(Levels, Products, testing::ValuesIn(supported_kernels()), level_name);

double at(const Strided& matrix, bool transposed, std::ptrdiff_t row, std::ptrdiff_t column) {
  return transposed ? matrix(column, row) : matrix(row, column);
}

TEST_P(Products, AreThoseOfPlainLoops) {
  for (int time = 0; time < 60; ++time) {
    const std::ptrdiff_t rows = any_size(), inner = any_size(), columns = any_size();
    const bool left = any_bool(), right = any_bool();
    const Strided a = left ? Strided::random(inner, rows, random_) : Strided::random(rows, inner, random_);
    const Strided b = right ? Strided::random(columns, inner, random_) : Strided::random(inner, columns, random_);
    const Strided before = Strided::random(rows, columns, random_);
    Strided sum = before;
    kernels().add_product(-0.75, a.operand(left), b.operand(right), sum.view());
    for (std::ptrdiff_t i = 0; i < rows; ++i)
      for (std::ptrdiff_t j = 0; j < columns; ++j) {
        PlainSum plain;
        plain.add(1.0, before(i, j));
        for (std::ptrdiff_t k = 0; k < inner; ++k) plain.add(-0.75 * at(a, left, i, k), at(b, right, k, j));
        ASSERT_NEAR(sum(i, j), static_cast<double>(plain.value), rounding(inner, plain.size))
            << rows << " × " << inner << " × " << columns << (left ? ", left" : "") << (right ? ", right" : "");
      }
    ASSERT_TRUE(sum.gaps_are_untouched());
  }
}

TEST_P(Products, SquaresReachTheLowerHalfAlone) {
  for (int time = 0; time < 60; ++time) {
    const std::ptrdiff_t rows = any_size(), inner = any_size();
    const bool transposed = any_bool();
    const Strided a = transposed ? Strided::random(inner, rows, random_) : Strided::random(rows, inner, random_);
    const Strided before = Strided::random(rows, rows, random_);
    Strided sum = before;
    sum.forget_above_diagonal();
    kernels().add_square(1.25, a.operand(transposed), sum.view());
    for (std::ptrdiff_t j = 0; j < rows; ++j)
      for (std::ptrdiff_t i = j; i < rows; ++i) {
        PlainSum plain;
        plain.add(1.0, before(i, j));
        for (std::ptrdiff_t k = 0; k < inner; ++k) plain.add(1.25 * at(a, transposed, i, k), at(a, transposed, j, k));
        ASSERT_NEAR(sum(i, j), static_cast<double>(plain.value), rounding(inner, plain.size)) << rows << " × " << inner;
      }
    ASSERT_TRUE(sum.is_untouched_above_diagonal());
    ASSERT_TRUE(sum.gaps_are_untouched());
  }
}

}  // namespace
}  // namespace lacuna::test
