#include "fitting/disturbance.h"

#include <gtest/gtest.h>

namespace lacuna::test {
namespace {

CommandSeries ramp(Hold hold) {
  CommandSeries commands;
  commands.hold = hold;
  commands.series.channels = {{"motor", "N*m"}};
  commands.series.times = Eigen::VectorXd::LinSpaced(11, 0.0, 1.0);
  commands.series.samples = commands.series.times;
  return commands;
}

double at(const CommandSeries& commands, Eigen::Index channel, double time) {
  const Eigen::VectorXd& times = commands.series.times;
  Eigen::Index after = 0;
  while (after < times.size() && times(after) <= time) ++after;
  if (after == times.size() || commands.hold == Hold::zero_order) return commands.series.samples(after - 1, channel);
  const double share = (time - times(after - 1)) / (times(after) - times(after - 1));
  return commands.series.samples(after - 1, channel) * (1.0 - share) + commands.series.samples(after, channel) * share;
}

class ForcePulses : public testing::TestWithParam<Hold> {};

TEST_P(ForcePulses, ActDuringTheirIntervalsAlone) {
  const CommandSeries recorded = ramp(GetParam());
  const CommandSeries pulsed = with_force_pulses(recorded, {"hinge", "pulse", 1.0}, {{0.25, 0.32}, {0.75, 0.9}}, 3.0);
  ASSERT_EQ(pulsed.series.channels.size(), 2U);
  for (const double time : {0.05, 0.24, 0.33, 0.5, 0.74, 0.95}) EXPECT_EQ(at(pulsed, 1, time), 0.0) << time;
  for (const double time : {0.26, 0.31, 0.76, 0.85, 0.89}) EXPECT_NEAR(at(pulsed, 1, time), 3.0, 1e-12) << time;
  for (const double time : {0.05, 0.26, 0.31, 0.5, 0.77, 0.95})
    EXPECT_NEAR(at(pulsed, 0, time), at(recorded, 0, time), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(BothHolds, ForcePulses, testing::Values(Hold::zero_order, Hold::first_order));

}  // namespace
}  // namespace lacuna::test
