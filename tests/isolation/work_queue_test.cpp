#include "isolation/work_queue.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(WorkQueue, HandsOutEachPieceOnceLargePartsFirst) {
  WorkQueue queue(40, 2);
  std::vector<std::size_t> all;
  std::size_t before = 40;
  for (auto part = queue.take(); !part.empty(); part = queue.take()) {
    EXPECT_LE(part.size(), before);
    before = part.size();
    all.insert(all.end(), part.begin(), part.end());
  }
  ASSERT_EQ(all.size(), 40U);
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i], i);
  EXPECT_EQ(before, 1U) << "so that all end at about the same time";
}

TEST(WorkQueue, WhatIsPutBackComesNext) {
  WorkQueue queue(3, 1);
  EXPECT_THAT(queue.take(), ElementsAre(0));
  queue.put_back({0, 7});
  EXPECT_THAT(queue.take(), ElementsAre(0));
  EXPECT_THAT(queue.take(), ElementsAre(7));
  queue.close();
  EXPECT_THAT(queue.take(), IsEmpty());
}

}  // namespace
}  // namespace lacuna
