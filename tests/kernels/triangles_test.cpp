#include "kernels/strided.h"

namespace lacuna::test {
namespace {

class Triangles : public OfEachLevel {
 protected:
  /// Symmetric, with eigenvalues from 1 on; above the diagonal nothing.
  Strided positive_definite(std::ptrdiff_t rows) {
    const Strided root = Strided::random(rows, rows, random_);
    Strided matrix(rows, rows);
    for (std::ptrdiff_t j = 0; j < rows; ++j)
      for (std::ptrdiff_t i = j; i < rows; ++i) {
        PlainSum sum;
        for (std::ptrdiff_t k = 0; k < rows; ++k) sum.add(root(i, k), root(j, k));
        matrix(i, j) = static_cast<double>(sum.value) + (i == j ? 1.0 : 0.0);
      }
    return matrix;
  }

  Strided lower(std::ptrdiff_t rows) {
    Strided matrix = Strided::random(rows, rows, random_);
    for (std::ptrdiff_t i = 0; i < rows; ++i) {
      matrix(i, i) += matrix(i, i) < 0.0 ? -1.0 : 1.0;
      for (std::ptrdiff_t j = 0; j < i; ++j) matrix(i, j) /= static_cast<double>(rows);
    }
    matrix.forget_above_diagonal();
    return matrix;
  }
};

INSTANTIATE_TEST_SUITE_P(Levels, Triangles, testing::ValuesIn(supported_kernels()), level_name);

TEST_P(Triangles, AFactorTimesItsTransposeIsTheMatrix) {
  for (const std::ptrdiff_t rows : kSizes) {
    const Strided matrix = positive_definite(rows);
    Strided factor = matrix;
    ASSERT_TRUE(kernels().factorize(factor.view()));
    for (std::ptrdiff_t j = 0; j < rows; ++j)
      for (std::ptrdiff_t i = j; i < rows; ++i) {
        PlainSum sum;
        for (std::ptrdiff_t k = 0; k <= j; ++k) sum.add(factor(i, k), factor(j, k));
        ASSERT_NEAR(matrix(i, j), static_cast<double>(sum.value), rounding(rows, sum.size)) << rows;
      }
    ASSERT_TRUE(factor.is_untouched_above_diagonal());
    ASSERT_TRUE(factor.gaps_are_untouched());
  }
}

TEST_P(Triangles, AMatrixThatIsNotPositiveDefiniteHasNoFactor) {
  for (const std::ptrdiff_t rows : kSizes)
    for (const std::ptrdiff_t bad : {rows / 2, rows - 1}) {
      if (rows == 0) continue;
      Strided matrix = positive_definite(rows);
      matrix(bad, bad) = -1.0;
      EXPECT_FALSE(kernels().factorize(matrix.view())) << rows;
    }
}

TEST_P(Triangles, SolutionsSolve) {
  for (const std::ptrdiff_t rows : kSizes)
    for (const std::ptrdiff_t columns : {0, 1, 4, 61})
      for (const bool transposed : {false, true}) {
        const Strided triangle = lower(rows), right = Strided::random(rows, columns, random_);
        Strided solution = right;
        kernels().solve(triangle.operand(transposed), solution.view());
        for (std::ptrdiff_t i = 0; i < rows; ++i)
          for (std::ptrdiff_t j = 0; j < columns; ++j) {
            PlainSum sum;
            for (std::ptrdiff_t k = transposed ? i : 0; k < (transposed ? rows : i + 1); ++k)
              sum.add(transposed ? triangle(k, i) : triangle(i, k), solution(k, j));
            ASSERT_NEAR(right(i, j), static_cast<double>(sum.value), rounding(rows, sum.size)) << rows;
          }
        ASSERT_TRUE(solution.gaps_are_untouched());
      }
}

TEST_P(Triangles, SolutionsFromTheRightSolve) {
  for (const std::ptrdiff_t rows : {0, 1, 5, 64})
    for (const std::ptrdiff_t columns : kSizes)
      for (const bool transposed : {false, true}) {
        const Strided triangle = lower(columns), right = Strided::random(rows, columns, random_);
        Strided solution = right;
        kernels().solve_from_right(triangle.operand(transposed), solution.view());
        for (std::ptrdiff_t i = 0; i < rows; ++i)
          for (std::ptrdiff_t j = 0; j < columns; ++j) {
            PlainSum sum;
            for (std::ptrdiff_t k = transposed ? 0 : j; k < (transposed ? j + 1 : columns); ++k)
              sum.add(solution(i, k), transposed ? triangle(j, k) : triangle(k, j));
            ASSERT_NEAR(right(i, j), static_cast<double>(sum.value), rounding(columns, sum.size)) << columns;
          }
        ASSERT_TRUE(solution.gaps_are_untouched());
      }
}

TEST_P(Triangles, InverseOfASquareTimesTheSquareIsTheIdentity) {
  for (const std::ptrdiff_t rows : kSizes) {
    const Strided triangle = lower(rows);
    Strided inverse = triangle;
    kernels().invert_square(inverse.view());
    const auto of_inverse = [&](std::ptrdiff_t i, std::ptrdiff_t j) { return i >= j ? inverse(i, j) : inverse(j, i); };
    for (std::ptrdiff_t j = 0; j < rows; ++j) {
      std::vector<long double> half(static_cast<std::size_t>(rows), 0.0L);  // Lᵀ · column j
      for (std::ptrdiff_t i = 0; i < rows; ++i)
        for (std::ptrdiff_t k = i; k < rows; ++k)
          half[static_cast<std::size_t>(i)] += static_cast<long double>(triangle(k, i)) * of_inverse(k, j);
      for (std::ptrdiff_t i = 0; i < rows; ++i) {
        long double sum = 0.0L;
        for (std::ptrdiff_t k = 0; k <= i; ++k) sum += triangle(i, k) * half[static_cast<std::size_t>(k)];
        ASSERT_NEAR(static_cast<double>(sum), i == j ? 1.0 : 0.0, rounding(rows, 10.0L)) << rows;
      }
    }
    ASSERT_TRUE(inverse.gaps_are_untouched());
  }
}

}  // namespace
}  // namespace lacuna::test
