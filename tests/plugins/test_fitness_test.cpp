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

TestPrediction readings(double first, double second) {
  TestPrediction prediction;
  prediction.sensors.samples.resize(1, 2);
  prediction.sensors.samples << first, second;
  return prediction;
}

TEST(ModelDisagreement, IsHalfTheSquaredDifferenceInNoiseDeviationsOverAllPairs) {
  const TestFitness& disagreement = built_catalog().get<TestFitness>("model_disagreement");
  const std::vector<double> two = {2.0, 1.0, 0.0}, three = {3.0, 0.5, 0.0};
  EXPECT_EQ(disagreement.models(three), 3U);
  EXPECT_EQ(disagreement.score({}, std::vector{readings(1.0, 5.0), readings(4.0, 1.0)}, two), 12.5);  // (9 + 16) / 2
  const std::vector trio = {readings(0.0, 0.0), readings(1.0, 0.0), readings(0.0, 2.0)};
  EXPECT_EQ(disagreement.score({}, trio, three), 0.5 * (1.0 + 4.0 + 5.0) / 3.0 / 0.25);
}

TEST(ModelDisagreement, OfOneModelOrOfDifferentSensorsIsAnError) {
  const TestFitness& disagreement = built_catalog().get<TestFitness>("model_disagreement");
  const std::vector<double> parameters = {2.0, 1.0, 0.0};
  EXPECT_THAT([&] { disagreement.score({}, std::vector{readings(0.0, 0.0)}, parameters); },
              ThrowsMessage<Error>(HasSubstr("one model alone")));
  TestPrediction other;
  other.sensors.samples = TimeSeries::Samples::Zero(1, 3);
  EXPECT_THAT(
      [&] {
        disagreement.score({}, std::vector{readings(0.0, 0.0), other}, parameters);
      },
      ThrowsMessage<Error>(HasSubstr("same sensors")));
}

TEST(ModelDisagreement, WeighsEachChannelByItsOwnNoise) {
  const TestFitness& disagreement = built_catalog().get<TestFitness>("model_disagreement");
  const std::vector<double> own_noise = {2.0, 0.0, 0.0};
  std::vector two = {readings(0.0, 0.0), readings(3.0, 8.0)};
  two[0].noise = {1.0, 4.0};
  EXPECT_DOUBLE_EQ(disagreement.score({}, two, own_noise), 0.5 * (9.0 + 4.0));
  two[0].noise = {1.0, std::numeric_limits<double>::infinity()};
  EXPECT_DOUBLE_EQ(disagreement.score({}, two, own_noise), 4.5) << "a channel that nobody scores";
  two[0].noise.clear();
  EXPECT_THAT([&] { disagreement.score({}, two, own_noise); }, ThrowsMessage<Error>(HasSubstr("noise = ")));
}

/// A model with one value whose slope is `slope` in both channels.
TestPrediction fitted(double first, double second, double slope, double information) {
  TestPrediction prediction = readings(first, second);
  prediction.slopes = {TimeSeries::Samples::Constant(1, 2, slope)};
  prediction.information = Eigen::MatrixXd::Constant(1, 1, information);
  return prediction;
}

TEST(ModelDisagreement, CountsWhatARefitLeaves) {
  const TestFitness& disagreement = built_catalog().get<TestFitness>("model_disagreement");
  const std::vector<double> refit = {2.0, 1.0, 1.0};
  EXPECT_TRUE(disagreement.wants_slopes(refit));
  // A difference along the slope goes away, but for what the trials so far hold against it.
  EXPECT_NEAR(disagreement.score({}, std::vector{fitted(0, 0, 1, 1e-9), fitted(3, 3, 1, 1e-9)}, refit), 0.0, 1e-7);
  // min over v of 2 (3 - v)^2 + 2 v^2 is 9 at v = 1.5.
  EXPECT_NEAR(disagreement.score({}, std::vector{fitted(0, 0, 1, 2.0), fitted(3, 3, 1, 2.0)}, refit), 4.5, 1e-12);
  // A difference across it stays.
  EXPECT_NEAR(disagreement.score({}, std::vector{fitted(0, 0, 1, 1e-9), fitted(3, -3, 1, 1e-9)}, refit), 9.0, 1e-7);
  EXPECT_THAT(
      [&] {
        disagreement.score({}, std::vector{fitted(0, 0, 1, 1.0), readings(0, 0)}, refit);
      },
      testing::Not(testing::Throws<std::out_of_range>()));
}

TEST(InformationGain, IsHalfTheLogarithmOfHowMuchSmallerTheVolumeGets) {
  const TestFitness& gain = built_catalog().get<TestFitness>("information_gain");
  TestPrediction prediction = readings(0.0, 0.0);
  prediction.noise = {0.5, 2.0};
  // The first value moves channel 1 by 4 deviations, the second channel 2 by 3; nothing else.
  prediction.slopes = {TimeSeries::Samples::Zero(1, 2), TimeSeries::Samples::Zero(1, 2), {}};
  prediction.slopes[0](0, 0) = 2.0;
  prediction.slopes[1](0, 1) = 6.0;
  prediction.information = 12.0 * Eigen::MatrixXd::Identity(3, 3);
  const double expected = 0.5 * (std::log((12.0 + 16.0) / 12.0) + std::log((12.0 + 9.0) / 12.0));
  EXPECT_NEAR(gain.score({}, {&prediction, 1}, std::vector{1.0}), expected, 1e-12);
  // Of two models the mean; one without slopes learns nothing.
  EXPECT_NEAR(gain.score({}, std::vector{prediction, readings(0.0, 0.0)}, std::vector{2.0}), 0.5 * expected, 1e-12);
  prediction.noise[1] = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(gain.score({}, {&prediction, 1}, std::vector{1.0}), 0.5 * std::log(28.0 / 12.0), 1e-12);
}

TEST(InformationGain, WithoutNoiseOrPredictionIsAnError) {
  const TestFitness& gain = built_catalog().get<TestFitness>("information_gain");
  EXPECT_THAT([&] { gain.score({}, {}, std::vector{1.0}); }, ThrowsMessage<Error>(HasSubstr("no prediction")));
  TestPrediction silent = fitted(0.0, 0.0, 1.0, 1.0);
  EXPECT_THAT([&] { gain.score({}, {&silent, 1}, std::vector{1.0}); }, ThrowsMessage<Error>(HasSubstr("noise")));
}

}  // namespace
}  // namespace lacuna
