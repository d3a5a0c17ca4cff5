#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <map>

namespace lacuna {
namespace {

constexpr int kChildren = 20000;
constexpr double kFiveDeviations = 5.0;

RandomStream stream_of(std::uint64_t key) { return RandomStream(std::vector<std::uint64_t>{key}); }

GenomeLayout layout_of(std::size_t genes, const Gene& gene) {
  GenomeLayout layout;
  layout.genes.assign(genes, gene);
  return layout;
}

const Gene kReal = {"x", "1", GeneKind::real, -1.0, 3.0};
const Gene kInteger = {"n", "1", GeneKind::integer, 0.0, 3.0};

TEST(UniformReset, NewValuesAreUniform) {
  const auto& mutation = built_catalog().get<MutationOperator>("uniform_reset");
  const GenomeLayout layout = layout_of(1, kReal);
  double sum = 0.0, squares = 0.0;
  for (std::uint64_t key = 0; key < kChildren; ++key) {
    RandomStream random = stream_of(key);
    const double value = mutation.vary(std::array{Genome{0.0}}, layout, std::array{1.0}, random)[0];
    sum += value;
    squares += (value - 1.0) * (value - 1.0);
  }
  const double variance = 16.0 / 12.0;
  EXPECT_NEAR(sum / kChildren, 1.0, kFiveDeviations * std::sqrt(variance / kChildren));
  EXPECT_NEAR(squares / kChildren, variance, 0.02 * variance);
}

TEST(UniformReset, WholeNumbersAreEquallyLikely) {
  const auto& mutation = built_catalog().get<MutationOperator>("uniform_reset");
  const GenomeLayout layout = layout_of(1, kInteger);
  std::map<double, int> counts;
  for (std::uint64_t key = 0; key < kChildren; ++key) {
    RandomStream random = stream_of(key);
    ++counts[mutation.vary(std::array{Genome{2.0}}, layout, std::array{1.0}, random)[0]];
  }
  ASSERT_EQ(counts.size(), 4U);
  for (const auto& [value, count] : counts)
    EXPECT_NEAR(count, kChildren / 4.0, kFiveDeviations * std::sqrt(kChildren * 3.0 / 16.0)) << value;
}

TEST(UniformReset, ExpectingNoneIsACopy) {
  const Genome parent(50, 0.5);
  RandomStream random = stream_of(1);
  EXPECT_EQ(built_catalog()
                .get<MutationOperator>("uniform_reset")
                .vary(std::array{parent}, layout_of(50, kReal), std::array{0.0}, random),
            parent);
}

TEST(Gaussian, MovesHaveTheDeviationOfTheRange) {
  const auto& mutation = built_catalog().get<MutationOperator>("gaussian");
  const GenomeLayout layout = layout_of(1, kReal);
  constexpr double kSigma = 0.05;
  double sum = 0.0, squares = 0.0;
  for (std::uint64_t key = 0; key < kChildren; ++key) {
    RandomStream random = stream_of(key);
    const double move = mutation.vary(std::array{Genome{1.0}}, layout, std::array{1.0, kSigma}, random)[0] - 1.0;
    sum += move;
    squares += move * move;
  }
  const double deviation = kSigma * 4.0;
  EXPECT_NEAR(sum / kChildren, 0.0, kFiveDeviations * deviation / std::sqrt(kChildren));
  EXPECT_NEAR(squares / kChildren, deviation * deviation, 0.06 * deviation * deviation);
}

/// From a bound all moves go inward, so that half a normal distribution is folded onto the other.
TEST(Gaussian, ReflectsAtTheBounds) {
  const auto& mutation = built_catalog().get<MutationOperator>("gaussian");
  const GenomeLayout layout = layout_of(1, kReal);
  constexpr double kSigma = 0.05;
  double sum = 0.0;
  for (std::uint64_t key = 0; key < kChildren; ++key) {
    RandomStream random = stream_of(key);
    sum += 3.0 - mutation.vary(std::array{Genome{3.0}}, layout, std::array{1.0, kSigma}, random)[0];
  }
  const double half_normal_mean = kSigma * 4.0 * std::sqrt(2.0 / M_PI);
  EXPECT_NEAR(sum / kChildren, half_normal_mean, kFiveDeviations * kSigma * 4.0 / std::sqrt(kChildren));
}

TEST(ReflectedValue, FoldsAsOftenAsItTakes) {
  constexpr double kTolerance = 1e-14;
  for (const auto& [value, inside] : std::initializer_list<std::pair<double, double>>{
           {0.5, 0.5}, {3.5, 2.5}, {-1.5, -0.5}, {7.5, -0.5}, {-5.5, 2.5}, {8.0 * 1000 + 0.25, 0.25}})
    EXPECT_NEAR(reflected_value(kReal, value), inside, kTolerance) << value;
  EXPECT_EQ(reflected_value(kInteger, 3.4), 3.0);
  EXPECT_EQ(reflected_value(kInteger, -1.2), 1.0);
  EXPECT_EQ(reflected_value({"fixed", "1", GeneKind::real, 2.0, 2.0}, 9.0), 2.0);
}

TEST(OnePointCrossover, JoinsTwoParentsAtEachCutEquallyOften) {
  const auto& crossover = built_catalog().get<MutationOperator>("one_point_crossover");
  ASSERT_EQ(crossover.parents(), 2U);
  const GenomeLayout layout = layout_of(5, kReal);
  const std::array parents{Genome(5, 0.0), Genome(5, 1.0)};
  std::map<Genome, int> counts;
  for (std::uint64_t key = 0; key < kChildren; ++key) {
    RandomStream random = stream_of(key);
    ++counts[crossover.vary(parents, layout, {}, random)];
  }
  EXPECT_THAT(counts,
              testing::UnorderedElementsAre(testing::Key(Genome{0, 1, 1, 1, 1}), testing::Key(Genome{0, 0, 1, 1, 1}),
                                            testing::Key(Genome{0, 0, 0, 1, 1}), testing::Key(Genome{0, 0, 0, 0, 1})));
  for (const auto& [child, count] : counts)
    EXPECT_NEAR(count, kChildren / 4.0, kFiveDeviations * std::sqrt(kChildren * 3.0 / 16.0));
}

TEST(OnePointCrossover, CutsBetweenRows) {
  GenomeLayout layout = layout_of(6, kReal);
  layout.row = 3;
  const std::array parents{Genome(6, 0.0), Genome(6, 1.0)};
  for (std::uint64_t key = 0; key < 50; ++key) {
    RandomStream random = stream_of(key);
    EXPECT_EQ(built_catalog().get<MutationOperator>("one_point_crossover").vary(parents, layout, {}, random),
              (Genome{0, 0, 0, 1, 1, 1}));
  }
}

/// Half the children have a new uniform value, the others moved by a distance whose logarithm is uniform.
TEST(ResetOrNudge, ResetsHalfAndMovesTheOthersByStepsOfAllSizes) {
  constexpr double kRange = 4.0, kMiddle = 1.0;
  const auto& mutation = built_catalog().get<MutationOperator>("reset_or_nudge");
  const GenomeLayout layout = layout_of(1, kReal);
  int small = 0, up = 0;
  double decades = 0.0, resets = 0.0;
  for (std::uint64_t key = 0; key < kChildren; ++key) {
    RandomStream random = stream_of(key);
    const double moved =
        mutation.vary(std::array{Genome{kMiddle}}, layout, std::array{0.5, 1.0, 7.0, 1.0}, random)[0] - kMiddle;
    if (std::abs(moved) > 0.1 * kRange) {
      resets += 1.0;
      continue;
    }
    if (std::abs(moved) > 0.01 * kRange) continue;  // either of them
    ++small;
    up += moved > 0.0 ? 1 : 0;
    decades += -std::log10(std::abs(moved) / kRange);
  }
  // A new value is farther than a tenth of the range from the middle with 0.8; of those nearer than a hundredth, all
  // but a fiftieth of the resets have moved, by 2 to 7 decades.
  EXPECT_NEAR(resets / kChildren, 0.4, kFiveDeviations * std::sqrt(0.24 / kChildren));
  EXPECT_NEAR(small, kChildren * (0.5 * 5.0 / 6.0 + 0.01), kFiveDeviations * std::sqrt(0.25 * kChildren));
  EXPECT_NEAR(decades / small, 4.5, 0.1);
  EXPECT_NEAR(up, 0.5 * small, kFiveDeviations * std::sqrt(0.25 * small));
}

TEST(ResetOrNudge, ChangesOneGeneAndStaysWithinItsBounds) {
  const auto& mutation = built_catalog().get<MutationOperator>("reset_or_nudge");
  const Genome parent(10, kReal.upper);
  const GenomeLayout layout = layout_of(10, kReal);
  int at_bound = 0;
  for (std::uint64_t key = 0; key < 1000; ++key) {
    RandomStream random = stream_of(key);
    const Genome child = mutation.vary(std::array{parent}, layout, std::array{0.0, 1.0, 7.0, 1.0}, random);
    int changed = 0;
    for (std::size_t i = 0; i < child.size(); ++i) {
      EXPECT_LE(child[i], kReal.upper);
      changed += child[i] != parent[i] ? 1 : 0;
    }
    EXPECT_LE(changed, 1);
    at_bound += changed == 0 ? 1 : 0;
  }
  EXPECT_NEAR(at_bound, 500, kFiveDeviations * std::sqrt(250.0)) << "half of the moves lead out of the bounds";
  RandomStream random = stream_of(1);
  EXPECT_THROW(mutation.vary(std::array{parent}, layout, std::array{0.0, 7.0, 1.0, 1.0}, random), Error);
}

TEST(ResetOrNudge, ReflectsMovesAtABoundWhereItDoesNotClip) {
  const auto& mutation = built_catalog().get<MutationOperator>("reset_or_nudge");
  const GenomeLayout layout = layout_of(1, kReal);
  const std::array reflects{0.0, 0.0, 1.0, 0.0}, neither{0.0, 1.0, 7.0, 0.5};
  for (std::uint64_t key = 0; key < 100; ++key) {
    for (const double bound : {kReal.lower, kReal.upper}) {
      RandomStream random = stream_of(key);
      const double distance = std::abs(mutation.vary(std::array{Genome{bound}}, layout, reflects, random)[0] - bound);
      const double range = kReal.upper - kReal.lower;
      EXPECT_GE(distance, 0.099 * range) << "a move beyond the bound comes back by as much";
      EXPECT_LE(distance, range);
    }
  }
  RandomStream random = stream_of(1);
  EXPECT_THROW(mutation.vary(std::array{Genome{kReal.lower}}, layout, neither, random), Error);
}

}  // namespace
}  // namespace lacuna
