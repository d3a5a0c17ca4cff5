#include "prediction/reading_noise.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

const ChannelNoise kAtRest = {"angle", "rad", 1e-3, "rest"};

TEST(AgreedNoise, IsThatOfADiagnosis) {
  const ChannelNoise noise = agreed(kAtRest, {"angle", "rad", 1.1e-3, "smoothed"});
  EXPECT_EQ(noise.deviation, 1.1e-3);
  EXPECT_EQ(noise.origin, "smoothed");
}

TEST(AgreedNoise, IsNotFastMotionAndSaysSo) {
  const ChannelNoise noise = agreed(kAtRest, {"angle", "rad", 9e-3, "smoothed"});
  EXPECT_EQ(noise.deviation, 1e-3);
  EXPECT_THAT(noise.origin, testing::HasSubstr("rest; lacuna diagnose takes 9.00 mrad, the scatter"));
}

}  // namespace
}  // namespace lacuna
