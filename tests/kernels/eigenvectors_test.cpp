#include "kernels/strided.h"

namespace lacuna::test {
namespace {

class OfSymmetricMatrices : public OfEachLevel {};

INSTANTIATE_TEST_SUITE_P(Levels, OfSymmetricMatrices, testing::ValuesIn(supported_kernels()), level_name);

TEST_P(OfSymmetricMatrices, EigenvectorsAreOrthonormalAndStretchedByRisingValues) {
  for (const std::ptrdiff_t rows : kSizes) {
    Strided matrix = Strided::random(rows, rows, random_);
    matrix.forget_above_diagonal();
    Strided vectors = matrix;
    std::vector<double> values(static_cast<std::size_t>(rows));
    ASSERT_TRUE(kernels().find_eigenvectors(vectors.view(), values.data()));
    EXPECT_TRUE(std::is_sorted(values.begin(), values.end()));
    const double allowed = 10.0 * rounding(rows, static_cast<long double>(std::sqrt(static_cast<double>(rows)) + 1.0));
    for (std::ptrdiff_t j = 0; j < rows; ++j)
      for (std::ptrdiff_t i = 0; i < rows; ++i) {
        PlainSum stretched, alike;
        for (std::ptrdiff_t k = 0; k < rows; ++k) {
          stretched.add(i >= k ? matrix(i, k) : matrix(k, i), vectors(k, j));
          alike.add(vectors(k, i), vectors(k, j));
        }
        const double expected = values[static_cast<std::size_t>(j)] * vectors(i, j);
        ASSERT_NEAR(static_cast<double>(stretched.value), expected, allowed) << rows;
        ASSERT_NEAR(static_cast<double>(alike.value), i == j ? 1.0 : 0.0, allowed) << rows;
      }
    EXPECT_TRUE(vectors.gaps_are_untouched());
  }
}

}  // namespace
}  // namespace lacuna::test
