#include "foundation/text/counted.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

TEST(Counted, HasTheFormOfTheNumber) {
  EXPECT_EQ(counted(0, "trial"), "0 trials");
  EXPECT_EQ(counted(1, "trial"), "1 trial");
  EXPECT_EQ(counted(1, "body"), "1 body");
  EXPECT_EQ(counted(2, "body"), "2 bodies");
}

}  // namespace
}  // namespace lacuna
