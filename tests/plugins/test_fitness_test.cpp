#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TestPrediction prediction(const std::vector<double>& x) {
  TestPrediction prediction;
  const auto samples = static_cast<Eigen::Index>(x.size());
  prediction.centre_of_mass.samples = TimeSeries::Samples::Constant(samples, 3, 0.85);
  for (Eigen::Index i = 0; i < samples; ++i) prediction.centre_of_mass.samples(i, 0) = x[static_cast<std::size_t>(i)];
  return prediction;
}

double distance(const std::vector<TestPrediction>& predictions) {
  return built_catalog().get<TestFitness>("forward_distance").score({}, predictions, {});
}

TEST(ForwardDistance, IsEndMinusStartOfTheBestModel) {
  EXPECT_EQ(built_catalog().get<TestFitness>("forward_distance").models({}), 1U);
  EXPECT_EQ(distance({prediction({0.25, 9.0, 1.5})}), 1.25);
  EXPECT_EQ(distance({prediction({0.0, -2.0}), prediction({0.0, 5.0})}), -2.0);
}

TEST(ForwardDistance, OfAnExplosionIsNoNumber) {
  EXPECT_TRUE(std::isnan(distance({prediction({0.0, std::numeric_limits<double>::quiet_NaN()})})));
}

TEST(ForwardDistance, OfNothingIsAnError) {
  EXPECT_THAT([] { distance({}); }, ThrowsMessage<Error>(HasSubstr("no prediction")));
  EXPECT_THAT([] { distance({prediction({})}); }, ThrowsMessage<Error>(HasSubstr("no sample")));
}

TEST(RandomFitness, AsksNoModelAndPrefersNothing) {
  const TestFitness& random = built_catalog().get<TestFitness>("random");
  EXPECT_EQ(random.models({}), 0U);
  lacuna::Test longer;
  longer.duration = 10.0;
  EXPECT_EQ(random.score({}, {}, {}), random.score(longer, {}, {}));
}

}  // namespace
}  // namespace lacuna
