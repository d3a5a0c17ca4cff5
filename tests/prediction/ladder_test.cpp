#include "prediction/prediction_ladder.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

/// Stretches of two lengths: 20 of 10 samples, 4 of 50.
PredictionLadder two_lengths() {
  PredictionLadder ladder;
  ladder.lengths = {1.0, 5.0};
  ladder.noise = {{"angle", "rad", 1.0, ""}};
  ladder.layout = {{{0, 0.5}, {1, 0.5}}, 2, {0, 1}, 1};
  const auto add = [&](std::size_t length, Eigen::Index first, Eigen::Index size) {
    PredictedStretch& stretch = ladder.stretches.emplace_back();
    stretch.length = length;
    stretch.stretch = {0, first, first + size};
  };
  for (Eigen::Index i = 0; i < 20; ++i) add(0, 10 * i, 10);
  for (Eigen::Index i = 0; i < 4; ++i) add(1, 50 * i, 50);
  return ladder;
}

std::vector<Eigen::Index> firsts(const PredictionLadder& ladder, std::size_t length) {
  std::vector<Eigen::Index> all;
  for (const PredictedStretch& stretch : ladder.stretches)
    if (stretch.length == length) all.push_back(stretch.stretch.first);
  return all;
}

TEST(Thinned, KeepsStretchesOfEachLengthEvenlySpread) {
  const PredictionLadder few = thinned(two_lengths(), 50);
  EXPECT_EQ(firsts(few, 0), (std::vector<Eigen::Index>{20, 60, 100, 140, 180}));
  EXPECT_EQ(firsts(few, 1), (std::vector<Eigen::Index>{50, 150})) << "two at least";
  EXPECT_EQ(few.layout.cells.size(), 2U);
}

TEST(Thinned, KeepsAllWhereThereAreNotMore) {
  const PredictionLadder all = two_lengths();
  EXPECT_EQ(thinned(all, 1000).stretches.size(), all.stretches.size());
}

TEST(Shorter, HasTheFirstLengthsAloneWithTheWholeWeight) {
  const PredictionLadder part = shorter(two_lengths(), 1);
  EXPECT_EQ(part.stretches.size(), 20U);
  ASSERT_EQ(part.layout.cells.size(), 1U);
  EXPECT_DOUBLE_EQ(part.layout.cells[0].weight, 1.0);
}

}  // namespace
}  // namespace lacuna
