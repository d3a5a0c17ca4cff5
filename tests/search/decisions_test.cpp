#include "search/decisions.h"

#include <gtest/gtest.h>

#include <limits>

namespace lacuna {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

HorizonError error(double base, double answer, double base_held_out = kNone, double answer_held_out = kNone) {
  return {1.0, "angle", "rad", 1.0, base, answer, base_held_out, answer_held_out};
}

struct HelpCase {
  std::vector<HorizonError> horizons;
  int at, of;
  bool everywhere;
};

class WhereAnswerHelps : public testing::TestWithParam<HelpCase> {};

TEST_P(WhereAnswerHelps, CountsWhatStandsAboveTheFloor) {
  const Helped helped = where_answer_helps(GetParam().horizons);
  EXPECT_EQ(helped.at, GetParam().at);
  EXPECT_EQ(helped.of, GetParam().of);
  EXPECT_EQ(helps_everywhere(helped), GetParam().everywhere);
}

INSTANTIATE_TEST_SUITE_P(
    Table, WhereAnswerHelps,
    testing::Values(HelpCase{{error(9, 2), error(5, 3), error(2, 1)}, 3, 3, true},
                    HelpCase{{error(1.4, 1.4), error(5, 3)}, 1, 1, true},  // the first is at the floor
                    HelpCase{{error(9, 2), error(5, 4.9), error(3, 2.9)}, 1, 3, false},
                    HelpCase{{error(9, 2, 9, 2), error(5, 3, 5, 5.5)}, 1, 2, false},  // not where it was not fitted
                    HelpCase{{error(9, 2), error(8, 2), error(7, 2), error(5, 5)}, 3, 4, true},
                    HelpCase{{}, 0, 0, true}));

TEST(Decisions, LikelihoodsAreAskedNearTheFloorAndBelievedAtIt) {
  EXPECT_TRUE(is_near_floor(6.0));
  EXPECT_FALSE(is_near_floor(6.1));
  Diagnosis diagnosis;
  EXPECT_FALSE(explains_to_noise(diagnosis));
  diagnosis.ranking.emplace_back();
  diagnosis.ranking.front().times_floor = 1.9;
  EXPECT_TRUE(explains_to_noise(diagnosis));
  diagnosis.ranking.front().times_floor = 2.1;
  EXPECT_FALSE(explains_to_noise(diagnosis));
}

}  // namespace
}  // namespace lacuna
