#include "search/probed_laws.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

/// An effect with one value, which changes nothing at `neutral`.
Hypothesis one_of(Scale scale, double lower, double upper, double neutral) {
  Hypothesis one;
  one.entry.effect = "effect";
  one.definition.free = {{{"effect.effect.value", "1", lower, upper, neutral, scale}, ""}};
  one.own = {0};
  one.neutral = {neutral};
  return one;
}

double at_size(const Hypothesis& hypothesis, double probed, double size) {
  return values_at_sizes(hypothesis, {{{probed}, 0, false}}, Eigen::VectorXd::Constant(1, size)).front();
}

TEST(ValuesAtSizes, GoAsFarFromNothingOnALinearScale) {
  EXPECT_DOUBLE_EQ(at_size(one_of(Scale::linear, -10.0, 10.0, 1.0), 1.5, -4.0), -1.0);
  EXPECT_DOUBLE_EQ(at_size(one_of(Scale::linear, 0.0, 10.0, 1.0), 1.5, -4.0), 0.0) << "within the range";
}

/// A reading that is too large by 1.2 and one that is too small by 1/1.2 are as far from the right one.
TEST(ValuesAtSizes, OfAFactorGoAsManyTimesUpOrDown) {
  const Hypothesis gain = one_of(Scale::logarithmic, 0.01, 100.0, 1.0);
  EXPECT_DOUBLE_EQ(at_size(gain, 1.2, 2.0), 1.44);
  EXPECT_DOUBLE_EQ(at_size(gain, 1.2, -2.0), 1.0 / 1.44);
  EXPECT_DOUBLE_EQ(at_size(gain, 1.2, 0.0), 1.0);
}

TEST(ValuesAtSizes, OfWhatChangesNothingAtAnEndAreInProportionToIt) {
  EXPECT_DOUBLE_EQ(at_size(one_of(Scale::logarithmic, 1e-6, 100.0, 1e-6), 0.5, 3.0), 1.5);
  EXPECT_DOUBLE_EQ(at_size(one_of(Scale::logarithmic, 1.0, 1e6, 1e6), 900.0, 3.0), 300.0) << "a stiffness";
}

/// A scale of 0.5 is promised at 1.2^-20 to first order; a fit that begins there does not come back.
TEST(StartingValues, OfAFactorAreNearerToo) {
  const Hypothesis gain = one_of(Scale::logarithmic, 0.01, 100.0, 1.0);
  const auto starts = starting_values(gain, {{{1.2}, 0, false}}, Eigen::VectorXd::Constant(1, -20.0));
  const auto nearest = [&](double value) {
    double least = 1e300;
    for (const std::vector<double>& start : starts) least = std::min(least, std::abs(std::log(start.front() / value)));
    return least;
  };
  EXPECT_LT(nearest(0.5), 0.2);
  EXPECT_LT(nearest(1.2), 1e-12) << "the probe itself";
}

TEST(StartingValues, OfASizeAreWhatItPromisesTheRootAndTheProbe) {
  const auto starts =
      starting_values(one_of(Scale::linear, -10.0, 10.0, 0.0), {{{0.5}, 0, false}}, Eigen::VectorXd::Constant(1, 4.0));
  EXPECT_EQ(starts, (std::vector<std::vector<double>>{{2.0}, {1.0}, {0.5}}));
}

}  // namespace
}  // namespace lacuna
