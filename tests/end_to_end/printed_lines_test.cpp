#include "end_to_end/printed_lines.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

TEST(Difference, SeesAnotherWordAnotherFigureAndAMissingLine) {
  const std::vector<std::string> printed = {"pendulum · refitted 3 values, 1.7 s", "fit   9.15 mrad  ███"};
  EXPECT_EQ(difference({"pendulum · refitted 3 values, 24 s", "fit 9.1 mrad █"}, printed, 0.01), "");
  EXPECT_EQ(difference({"…", "fit 9.1 mrad"}, printed, 0.01), "");
  EXPECT_NE(difference({"…", "fit 9.4 mrad"}, printed, 0.01), "");
  EXPECT_NE(difference({"…", "fit 9.1 rad"}, printed, 0.01), "");
  EXPECT_NE(difference({"pendulum · refitted 3 values, 24 s"}, printed, 0.01), "");
  EXPECT_NE(difference({"pendulum · refitted 3 values, 24 s", "fit 9.1 mrad", "more"}, printed, 0.01), "");
}

TEST(Difference, LetsAFigureDifferByItsUncertainty) {
  const std::vector<std::string> printed = {"1 friction +1181 ± 255 nats 0.66 × floor"};
  EXPECT_EQ(difference({"1 friction +1128 ± 224 nats 0.66 × floor"}, printed, 0.01), "");
  EXPECT_NE(difference({"1 friction +1080 ± 224 nats 0.66 × floor"}, printed, 0.01), "");
  EXPECT_NE(difference({"1 friction +1128 ± 200 nats 0.66 × floor"}, printed, 0.01), "");
  EXPECT_NE(difference({"1 friction -1181 ± 255 nats 0.66 × floor"}, printed, 0.01), "");
  EXPECT_EQ(difference({"1 friction +1181 ± 255 nats 0.72 × floor"}, printed, 0.01), "");
  EXPECT_NE(difference({"1 friction +1181 ± 255 nats 0.76 × floor"}, printed, 0.01), "");
  EXPECT_EQ(difference({"1 friction  +1128 ±  224 nats  0.66 × floor"}, printed, 0.01), "") << "padded";
  EXPECT_NE(difference({"1 friction  +900 ±  224 nats  0.66 × floor"}, printed, 0.01), "") << "padded";
}

TEST(Difference, LetsAProbabilityDifferByItsLastDigit) {
  EXPECT_EQ(difference({"verdict effect_found · probability 0.85 (calibrated)"},
                       {"verdict effect_found · probability 0.86 (calibrated)"}, 0.05),
            "");
  EXPECT_NE(difference({"verdict effect_found · probability 0.84 (calibrated)"},
                       {"verdict effect_found · probability 0.86 (calibrated)"}, 0.05),
            "");
  EXPECT_EQ(difference({"chance · p 0.72"}, {"chance · p 0.67"}, 0.01), "");
  EXPECT_EQ(difference({"chance: below 5.3 nats"}, {"chance: below 5.8 nats"}, 0.01), "");
  EXPECT_NE(difference({"chance: below 5.3 nats"}, {"chance: below 6.8 nats"}, 0.01), "");
  EXPECT_NE(difference({"chance · p 0.06"}, {"chance · p 0.0005"}, 0.01), "");
}

/// 5.7 % and 9.0 % of an error are left.
TEST(Difference, ComparesWhatIsLeftOfAnError) {
  EXPECT_EQ(difference({"over 2 s −94.3 %"}, {"over 2 s −94.1 %"}, 0.05), "");
  EXPECT_NE(difference({"over 2 s −94.3 %"}, {"over 2 s −91.0 %"}, 0.05), "");
  EXPECT_NE(difference({"over 2 s −94.3 %"}, {"over 2 s +94.3 %"}, 0.05), "");
}

TEST(Difference, LooksPastTheTimesAndHashesOfRuns) {
  const std::string hash(64, 'a'), other(64, 'b');
  const std::vector<std::string> printed = {"pass 1 · error 0.5 · 12 s",
                                            "run 1 · 1 min 3 s · storage 4.1 % of the time", hash + " run 1"};
  EXPECT_EQ(difference({"pass 1 · error 0.5 · 9.1 s", "run 1 · 0.9 s · storage 2.0 % of the time", other + " run 1"},
                       printed, 0),
            "");
  EXPECT_NE(difference({"pass 1 · error 2.5 · 9.1 s", "…"}, printed, 0.0), "") << "a figure that is no time";
  EXPECT_NE(difference({"…", other.substr(1) + " run 1"}, printed, 0.0), "") << "no hash";
}

}  // namespace
}  // namespace lacuna
