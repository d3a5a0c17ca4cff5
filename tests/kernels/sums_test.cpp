#include "kernels/strided.h"

namespace lacuna::test {
namespace {

class Sums : public OfEachLevel {
 protected:
  std::vector<Strided> symmetric(std::ptrdiff_t count, std::ptrdiff_t rows) {
    std::vector<Strided> all;
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      all.push_back(Strided::random(rows, rows, random_, 0));
      all.back().forget_above_diagonal();
    }
    return all;
  }
};

INSTANTIATE_TEST_SUITE_P(Levels, Sums, testing::ValuesIn(supported_kernels()), level_name);

std::vector<const double*> pointers(const std::vector<Strided>& matrices) {
  std::vector<const double*> all;
  for (const Strided& one : matrices) all.push_back(one.numbers());
  return all;
}

TEST_P(Sums, OfWeightedColumnsAreThoseOfPlainLoops) {
  for (const std::ptrdiff_t rows : kSizes)
    for (std::ptrdiff_t count = 0; count <= 7; ++count) {
      const std::vector<Strided> terms = symmetric(count, rows);
      const Strided factors = Strided::random(rows, count, random_);
      Strided sum(rows, rows);
      kernels().sum_lower(pointers(terms).data(), factors.operand(), sum.view());
      for (std::ptrdiff_t j = 0; j < rows; ++j)
        for (std::ptrdiff_t i = j; i < rows; ++i) {
          PlainSum plain;
          for (std::ptrdiff_t k = 0; k < count; ++k) plain.add(terms[static_cast<std::size_t>(k)](i, j), factors(j, k));
          ASSERT_NEAR(sum(i, j), static_cast<double>(plain.value), rounding(count, plain.size)) << rows;
        }
      ASSERT_TRUE(sum.is_untouched_above_diagonal());
      ASSERT_TRUE(sum.gaps_are_untouched());
    }
}

TEST_P(Sums, TracesOfProductsAreThoseOfPlainLoops) {
  for (const std::ptrdiff_t rows : kSizes)
    for (std::ptrdiff_t count = 0; count <= 3; ++count) {
      const std::vector<Strided> terms = symmetric(count, rows);
      Strided weights = Strided::random(rows, rows, random_);
      weights.forget_above_diagonal();
      Strided traces(rows, count);
      kernels().trace_products(weights.operand(), pointers(terms).data(), traces.view());
      for (std::ptrdiff_t k = 0; k < count; ++k)
        for (std::ptrdiff_t j = 0; j < rows; ++j) {
          const Strided& term = terms[static_cast<std::size_t>(k)];
          PlainSum plain;
          plain.add(weights(j, j), term(j, j));
          for (std::ptrdiff_t i = j + 1; i < rows; ++i) plain.add(2.0 * weights(i, j), term(i, j));
          ASSERT_NEAR(traces(j, k), static_cast<double>(plain.value), 3.0 * rounding(rows, plain.size)) << rows;
        }
      ASSERT_TRUE(traces.gaps_are_untouched());
    }
}

}  // namespace
}  // namespace lacuna::test
