#include "answer/errors_by_length.h"

#include "answer/found_pendulum.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

/// Of the model as it is.
ErrorsByLength errors_of(const FoundPendulum& pendulum) { return {pendulum.data.data(), pendulum.found.sets[0]}; }

TEST(ErrorsByLengthTest, OfARightModelAreTheNoiseOfAReading) {
  const FoundPendulum right(two_recordings({.damping = 0.02}));
  const ErrorsByLength errors = errors_of(right);
  const PredictionLadder& ladder = right.data.data().ladder();
  EXPECT_NEAR(errors.times_floor(), 1.0, 0.15);
  for (std::size_t length = 0; length < ladder.lengths.size(); ++length) {
    ASSERT_TRUE(errors.is_read(length, 0));
    EXPECT_NEAR(errors.fitted(length, 0), ladder.noise[0].deviation, 0.3 * ladder.noise[0].deviation) << length;
  }
}

TEST(ErrorsByLengthTest, OfAMissingFrictionAreLargerAtTheLongestLength) {
  const FoundPendulum lacking(two_recordings({.damping = 0.02, .friction = 0.05}));
  const ErrorsByLength errors = errors_of(lacking);
  const PredictionLadder& ladder = lacking.data.data().ladder();
  EXPECT_GT(errors.times_floor(), 3.0);
  ASSERT_EQ(errors.longest().size(), 1U);
  const ChannelError longest = errors.longest()[0];
  EXPECT_EQ(longest.channel, "angle");
  EXPECT_EQ(longest.unit, "rad");
  EXPECT_EQ(longest.floor, ladder.noise[0].deviation);
  EXPECT_EQ(longest.fit, errors.fitted(ladder.lengths.size() - 1, 0));
  EXPECT_GT(longest.fit, errors.fitted(0, 0));
  EXPECT_EQ(errors.longest_length(), ladder.lengths.back());
}

TEST(ErrorsByLengthTest, AreUnknownOfHeldOutDataWhereThereAreNone) {
  const FoundPendulum pendulum(two_recordings({.damping = 0.02}));
  const ErrorsByLength errors = errors_of(pendulum);
  EXPECT_TRUE(std::isnan(errors.held_out(0, 0)));
}

TEST(ErrorsByLengthTest, AreThoseOfTheHeldOutRecordingBeside) {
  std::vector<Trial> trials = two_recordings({.damping = 0.02});
  trials.push_back(recorded({.inertia = kModelInertia, .damping = 0.02, .friction = 0.1}, "other.csv", sine, 3.0, 9));
  trials.back().held_out = true;
  const FoundPendulum pendulum(trials);
  const ErrorsByLength errors = errors_of(pendulum);
  const std::size_t last = pendulum.data.data().ladder().lengths.size() - 1;
  EXPECT_LT(errors.fitted(last, 0), 2.0 * pendulum.data.data().ladder().noise[0].deviation);
  EXPECT_GT(errors.held_out(last, 0), 5.0 * errors.fitted(last, 0)) << "its friction is not the model's";
}

TEST(ErrorsByHorizon, StandSideBySideForEachLength) {
  const FoundPendulum pendulum(two_recordings({.damping = 0.02, .friction = 0.05}), {"coulomb_friction"});
  const SearchData& data = pendulum.data.data();
  const ErrorsByLength base(data, pendulum.found.sets[0]), answer(data, pendulum.found.sets[1]);
  const std::vector<HorizonError> errors = errors_by_horizon(data, base, answer);
  ASSERT_EQ(errors.size(), data.ladder().lengths.size());
  for (std::size_t length = 0; length < errors.size(); ++length) {
    EXPECT_EQ(errors[length].horizon, data.ladder().lengths[length]);
    EXPECT_EQ(errors[length].base, base.fitted(length, 0));
    EXPECT_EQ(errors[length].answer, answer.fitted(length, 0));
    EXPECT_TRUE(std::isnan(errors[length].answer_held_out));
  }
  EXPECT_LT(errors.back().answer, 0.3 * errors.back().base);
}

}  // namespace
}  // namespace lacuna
