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

TEST(WithArticle, FollowsTheFirstLetter) {
  EXPECT_EQ(with_article("actuator"), "an actuator");
  EXPECT_EQ(with_article("effect"), "an effect");
  EXPECT_EQ(with_article("joint"), "a joint");
  EXPECT_EQ(with_article("unit"), "a unit");
}

}  // namespace
}  // namespace lacuna
