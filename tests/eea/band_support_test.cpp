#include "eea/ensemble/band_support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kClose = 1e-9;

/// Of one channel: ratios 1/n, 2/n ... up to `most`.
HeldOutTrial evenly(int number, double most, int readings = 100) {
  HeldOutTrial trial{number, number, {{}}};
  for (int i = 1; i <= readings; ++i) trial.ratios[0].push_back(most * i / readings);
  return trial;
}

TEST(BandSupport, CountsReadingsWithinTheBand) {
  const BandSupport support = support_of({evenly(1, 2.0), evenly(2, 2.0), evenly(3, 2.0)});
  ASSERT_EQ(support.channels.size(), 1U);
  EXPECT_EQ(support.channels[0].trials, 3U);
  EXPECT_NEAR(support.channels[0].inside.share, 0.5, kClose);
  EXPECT_NEAR(support.all.inside.share, 0.5, kClose);
  EXPECT_NEAR(support.channels[0].factor, 1.9, kClose) << "95 % of 0.02 ... 2.00 are not larger";
  EXPECT_NEAR(support.channels[0].error, 1.959963984540054 * 2.0 * std::sqrt(0.33835), kClose)
      << "(1² + ... + 100²) / 100³";
}

TEST(BandSupport, GivesEachTrialTheSameWeight) {
  const BandSupport support = support_of({evenly(1, 0.9, 1000), evenly(2, 0.9, 1000), evenly(3, 2.0, 10)});
  EXPECT_NEAR(support.all.inside.share, (1.0 + 1.0 + 0.5) / 3.0, kClose);
  EXPECT_NEAR(support.all.factor, 1.8, kClose) << "of the short trial less than 0.15 may lie outside";
}

TEST(BandSupport, HasAnIntervalOverTrialsNotOverReadings) {
  const HeldOutTrial right = evenly(1, 0.5, 5000), wrong{2, 2, {std::vector<double>(5000, 3.0)}};
  const BandSupport support = support_of({right, wrong, right, wrong});
  EXPECT_NEAR(support.all.inside.share, 0.5, kClose);
  EXPECT_LE(support.all.inside.lower, 0.0) << "all four drawn may be wrong: one in sixteen";
  EXPECT_GE(support.all.inside.upper, 1.0);
  const BandSupport again = support_of({right, wrong, right, wrong});
  EXPECT_EQ(support.all.inside.lower, again.all.inside.lower);
}

TEST(BandSupport, WidensWhatIsTooNarrow) {
  EnsembleBand band{TimeSeries::Samples::Zero(2, 1), TimeSeries::Samples::Constant(2, 1, 10.0)};
  widen(band, support_of({evenly(1, 2.0), evenly(2, 2.0), evenly(3, 2.0)}));
  EXPECT_NEAR(band.half_width(1, 0), 19.0, kClose);
}

TEST(BandSupport, WidensNothingOnTheWordOfTwoTrials) {
  const BandSupport support = support_of({evenly(1, 2.0), evenly(2, 2.0)});
  EXPECT_FALSE(support.enough());
  EXPECT_EQ(support.channels[0].widening(), 1.0);
  EXPECT_TRUE(std::isnan(support.widened.share));
}

TEST(BandSupport, NarrowsNothing) {
  const BandSupport support = support_of({evenly(1, 0.5), evenly(2, 0.5), evenly(3, 0.5)});
  EXPECT_NEAR(support.channels[0].factor, 0.475, kClose);
  EXPECT_EQ(support.channels[0].widening(), 1.0);
}

TEST(BandSupport, TriesTheFactorOnTrialsThatDidNotGiveIt) {
  const BandSupport alike = support_of({evenly(1, 2.0), evenly(2, 2.0), evenly(3, 2.0)});
  EXPECT_NEAR(alike.widened.share, 0.95, kClose);
  const BandSupport odd = support_of({evenly(1, 0.5), evenly(2, 0.5), evenly(3, 2.0)});
  EXPECT_NEAR(odd.widened.share, (1.0 + 1.0 + 0.5) / 3.0, kClose) << "the third is not foreseen by the others";
}

TEST(BandSupport, OfAChannelIsThatOfTheTrialsThatMeasuredIt) {
  HeldOutTrial both{1, 1, {{0.5}, {0.5}}}, first{2, 2, {{0.5}, {}}};
  const BandSupport support = support_of({both, first, both});
  EXPECT_EQ(support.channels[0].trials, 3U);
  EXPECT_EQ(support.channels[1].trials, 2U);
}

TEST(BandSupport, OfNoTrialSaysNothing) {
  const BandSupport support = support_of({});
  EXPECT_FALSE(support.enough());
  EXPECT_TRUE(std::isnan(support.all.inside.share));
}

TEST(BandRatios, LeaveOutWhatWasNotMeasured) {
  EnsembleBand band{TimeSeries::Samples::Zero(3, 2), TimeSeries::Samples::Constant(3, 2, 2.0)};
  Trial trial;
  trial.measured.samples = TimeSeries::Samples(3, 1);
  trial.measured.samples << 1.0, std::numeric_limits<double>::quiet_NaN(), -4.0;
  const std::vector<std::vector<double>> ratios = band_ratios(band, trial, {1});
  ASSERT_EQ(ratios.size(), 2U);
  EXPECT_TRUE(ratios[0].empty());
  EXPECT_EQ(ratios[1], (std::vector<double>{0.5, 2.0}));
}

TEST(BandRatios, OffABandWithoutWidthIsOutsideAndNoFactorHelps) {
  EnsembleBand band{TimeSeries::Samples::Zero(2, 1), TimeSeries::Samples::Zero(2, 1)};
  Trial trial;
  trial.measured.samples = TimeSeries::Samples(2, 1);
  trial.measured.samples << 0.0, 1.0;
  HeldOutTrial held_out;
  held_out.ratios = band_ratios(band, trial, {0});
  EXPECT_EQ(held_out.ratios[0].front(), 0.0);
  const BandSupport support = support_of({held_out, held_out, held_out});
  EXPECT_EQ(support.all.inside.share, 0.5);
  EXPECT_TRUE(std::isinf(support.channels[0].factor));
  EXPECT_EQ(support.channels[0].widening(), 1.0);
  EXPECT_EQ(support.widened.share, 0.5);
  widen(band, support);
  EXPECT_EQ(band.half_width(0, 0), 0.0);
}

}  // namespace
}  // namespace lacuna
