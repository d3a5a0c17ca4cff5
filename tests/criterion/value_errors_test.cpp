#include "criterion/value_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lacuna::value_errors_test {
namespace {

constexpr std::size_t kBlocks = 40;
constexpr int kReadings = 25;  ///< in a block

CellLayout one_cell() { return {{{0, 1.0}}, 1, std::vector<std::size_t>(kBlocks, 0), 1}; }

/// Readings of 2 × column with noise, of which a part lasts over whole blocks; a second column that is `ratio` times
/// the first.
BlockProducts drawn(std::uint64_t seed, double lasting, double ratio) {
  std::mt19937_64 bits(seed);
  std::normal_distribution<double> normal;
  BlockProducts products(one_cell(), 2);
  for (std::size_t b = 0; b < kBlocks; ++b) {
    const double common = lasting * normal(bits);
    for (int i = 0; i < kReadings; ++i) {
      const double column = 1.0 + 0.5 * std::sin(0.7 * i + static_cast<double>(b));
      const double other = ratio == 0.0 ? normal(bits) : ratio * column;
      const Eigen::Vector3d row(2.0 * column + common + normal(bits), column, other);
      products.at(0, b) += row * row.transpose();
      products.samples(0, b) += 1.0;
    }
  }
  return products;
}

const StepBounds kWide{Eigen::VectorXd::Constant(2, -1e6), Eigen::VectorXd::Constant(2, 1e6)};

/// How often ±2 standard errors hold the truth of the first value.
int hits(double lasting) {
  int hit = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const BlockProducts products = drawn(seed, lasting, 0.0);
    const LinearCost fit = least_cost(one_cell(), products, kWide);
    hit += std::abs(fit.step(0) - 2.0) < 2.0 * value_errors(one_cell(), products, fit).standard()(0) ? 1 : 0;
  }
  return hit;
}

TEST(ValueErrors, HoldTheTruthWithWhiteNoise) {
  EXPECT_GE(hits(0.0), 186);
  EXPECT_LE(hits(0.0), 200);
}

TEST(ValueErrors, HoldTheTruthWithNoiseThatLastsOverABlock) { EXPECT_GE(hits(2.0), 184); }

TEST(ValueErrors, GrowWithNoiseThatLasts) {
  const auto error = [](double lasting) {
    const BlockProducts products = drawn(7, lasting, 0.0);
    return value_errors(one_cell(), products, least_cost(one_cell(), products, kWide)).standard()(0);
  };
  EXPECT_GT(error(2.0), 4.0 * error(0.0));
}

TEST(ValueErrors, SayWhichValuesTheDataDoNotTell) {
  const BlockProducts twice = drawn(3, 0.0, 5.0);
  const ValueErrors errors = value_errors(one_cell(), twice, least_cost(one_cell(), twice, kWide));
  EXPECT_EQ(errors.is_told, (std::vector<bool>{false, false}));
  const BlockProducts apart = drawn(3, 0.0, 0.0);
  EXPECT_EQ(value_errors(one_cell(), apart, least_cost(one_cell(), apart, kWide)).is_told,
            (std::vector<bool>{true, true}));
}

}  // namespace
}  // namespace lacuna::value_errors_test
