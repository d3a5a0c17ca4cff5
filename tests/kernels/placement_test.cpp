#include "kernels/strided.h"

#include <cstdint>
#include <cstring>
#include <functional>

namespace lacuna::test {
namespace {

/// Digits must not depend on where numbers lie in memory: a thread that allocates elsewhere would get another result.
class Placement : public OfEachLevel {
 protected:
  static constexpr std::size_t kPlaces = 4;  ///< that registers of four numbers tell apart

  /// Three symmetric positive definite matrices of `rows`, written behind each other; what a kernel makes of them.
  std::vector<double> made_at(std::size_t place, std::ptrdiff_t rows,
                              const std::function<void(double* a, double* b, double* c)>& kernel) const {
    const auto size = static_cast<std::size_t>(rows * rows);
    std::vector<double> memory(3 * size + 2 * kPlaces);
    double* first = memory.data();
    while (reinterpret_cast<std::uintptr_t>(first) % (kPlaces * sizeof(double)) != 0) ++first;
    first += place;
    std::mt19937_64 source(static_cast<std::uint64_t>(rows));
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (std::size_t matrix = 0; matrix < 3; ++matrix)
      for (std::ptrdiff_t column = 0; column < rows; ++column)
        for (std::ptrdiff_t row = column; row < rows; ++row) {
          double* numbers = first + matrix * size;
          numbers[row * rows + column] = numbers[column * rows + row] =
              row == column ? 2.0 * static_cast<double>(rows) : uniform(source);
        }
    kernel(first, first + size, first + 2 * size);
    return {first, first + 3 * size};
  }

  void expect_same(const std::function<void(std::ptrdiff_t rows, double* a, double* b, double* c)>& kernel) const {
    for (std::ptrdiff_t rows = 1; rows <= 70; ++rows) {
      const auto of_rows = [&](double* a, double* b, double* c) { kernel(rows, a, b, c); };
      const std::vector<double> aligned = made_at(0, rows, of_rows);
      for (std::size_t place = 1; place < kPlaces; ++place) {
        const std::vector<double> elsewhere = made_at(place, rows, of_rows);
        ASSERT_EQ(std::memcmp(aligned.data(), elsewhere.data(), aligned.size() * sizeof(double)), 0) << rows;
      }
    }
  }
};

INSTANTIATE_TEST_SUITE_P(Levels, Placement, testing::ValuesIn(supported_kernels()), level_name);

DenseOperand read(const double* numbers, std::ptrdiff_t rows, bool transposed = false) {
  return {numbers, rows, rows, rows, transposed};
}
DenseView written(double* numbers, std::ptrdiff_t rows) { return {numbers, rows, rows, rows}; }

TEST_P(Placement, ChangesNoDigitOfAProduct) {
  for (const bool left : {false, true})
    for (const bool right : {false, true})
      expect_same([&](std::ptrdiff_t rows, double* a, double* b, double* c) {
        kernels().add_product(0.7, read(a, rows, left), read(b, rows, right), written(c, rows));
      });
  for (const bool transposed : {false, true})
    expect_same([&](std::ptrdiff_t rows, double* a, double*, double* c) {
      kernels().add_square(0.7, read(a, rows, transposed), written(c, rows));
    });
}

TEST_P(Placement, ChangesNoDigitOfAFactorOrASolution) {
  expect_same([&](std::ptrdiff_t rows, double* a, double* b, double* c) {
    ASSERT_TRUE(kernels().factorize(written(a, rows)));
    kernels().solve(read(a, rows), written(b, rows));
    kernels().solve(read(a, rows, true), written(b, rows));
    kernels().solve_from_right(read(a, rows), written(c, rows));
    kernels().solve_from_right(read(a, rows, true), written(c, rows));
    kernels().invert_square(written(a, rows));
  });
}

TEST_P(Placement, ChangesNoDigitOfEigenvectors) {
  expect_same([&](std::ptrdiff_t rows, double* a, double* b, double*) {
    ASSERT_TRUE(kernels().find_eigenvectors(written(a, rows), b));
  });
}

TEST_P(Placement, ChangesNoDigitOfASum) {
  expect_same([&](std::ptrdiff_t rows, double* a, double* b, double* c) {
    const std::ptrdiff_t few = std::min<std::ptrdiff_t>(rows, 3);
    const std::vector<const double*> terms(static_cast<std::size_t>(few), a);
    kernels().sum_lower(terms.data(), {b, rows, few, rows, false}, written(c, rows));
    kernels().trace_products(read(a, rows), terms.data(), {b, rows, few, rows});
  });
}

}  // namespace
}  // namespace lacuna::test
