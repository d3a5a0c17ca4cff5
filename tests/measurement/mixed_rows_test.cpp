#include "measurement/series/glitches.h"
#include "measurement/series/second_stream.h"

#include "measurement_fixture.h"
#include "mixed_columns.h"

#include <fmt/format.h>

#include <cmath>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// What a column gets, as readings of a joint do: the second stream first, then glitches among the rest.
struct Answer {
  bool refused = false, kept_as_motion = false;
  std::vector<bool> left_out;

  std::size_t count() const { return static_cast<std::size_t>(std::count(left_out.begin(), left_out.end(), true)); }
};

constexpr double kMostGlitches = 0.1;  // as the program refuses

Answer answer_of(const MixedColumn& column) {
  Answer answer;
  answer.left_out.assign(column.values.size(), false);
  std::vector<double> values = column.values;
  const auto leave_out = [&](const std::vector<std::size_t>& readings) {
    for (const std::size_t i : readings) {
      answer.left_out[i] = true;
      values[i] = std::nan("");
    }
  };
  if (const auto stream = find_second_stream(column.times, values)) {
    answer.refused = !stream->is_sure;
    leave_out(stream->readings);
  }
  const Glitches glitches = find_glitches(column.times, values);
  answer.kept_as_motion = glitches.may_be_motion;
  if (!glitches.may_be_motion) leave_out(glitches.readings);
  answer.refused |= !glitches.may_be_motion &&
                    static_cast<double>(glitches.readings.size()) > kMostGlitches * static_cast<double>(glitches.of);
  return answer;
}

/// Of many columns.
struct Rates {
  int columns = 0, refused = 0;
  int right = 0;  ///< refused, or no reading of another course is left that is more than noise off
  double good_left_out = 0.0, good = 0.0;

  double right_share() const { return static_cast<double>(right) / columns; }
  double lost_share() const { return good > 0.0 ? good_left_out / good : 0.0; }
};

constexpr double kRates[] = {50.0, 100.0, 400.0};  // 1/s
constexpr double kNoises[] = {0.0, 1e-3, 1e-2};
constexpr double kQuanta[] = {0.0, 1e-3};
constexpr double kClose = 0.02;  ///< of a motion of size 1: a reading of another course that is as close does no harm
constexpr double kNoiseDeviations = 6.0;

void count(const TestMotion& motion, double noise, const MixedColumn& column, Rates& rates) {
  const Answer answer = answer_of(column);
  ++rates.columns;
  rates.refused += answer.refused;
  bool right = true;
  std::vector<bool> is_bad(column.values.size(), false);
  for (const std::size_t i : column.bad) {
    is_bad[i] = true;
    const double off = std::abs(column.values[i] - motion.at(column.times[i]));
    right = right && (answer.left_out[i] || off < kClose + kNoiseDeviations * noise);
  }
  rates.right += right || answer.refused;
  for (std::size_t i = 0; i < is_bad.size() && !answer.refused; ++i) {
    if (is_bad[i]) continue;
    rates.good += 1.0;
    rates.good_left_out += answer.left_out[i];
  }
}

/// Over all motions, rates, noises and quantisers.
Rates rates_of(const std::function<void(MixedColumn&, std::mt19937&)>& spoil) {
  Rates rates;
  std::mt19937 random(7);
  for (const TestMotion& motion : test_motions())
    for (const double rate : kRates)
      for (const double noise : kNoises)
        for (const double quantum : kQuanta) {
          MixedColumn column = sampled(motion, {rate, noise, quantum}, random);
          spoil(column, random);
          count(motion, noise, column, rates);
        }
  return rates;
}

const auto kZeros = [](double) { return 0.0; };
const auto kOtherJoint = [](double t) { return 0.7 * std::cos(2.8 * t + 0.2) + 0.2; };

Rates rates_with(const std::function<double(double)>& other, std::size_t every, bool irregular) {
  return rates_of(
      [&](MixedColumn& column, std::mt19937& random) { add_rows_between(other, every, irregular, column, random); });
}

TEST(MixedRows, CleanColumnsKeepAllReadings) {
  std::mt19937 random(7);
  for (const auto& motions : {test_motions(), test_velocities()})
    for (const TestMotion& motion : motions)
      for (const double rate : {30.0, 100.0, 400.0})
        for (const double noise : {0.0, 1e-4, 1e-2, 0.05})
          for (const double quantum : {0.0, 1e-3, 0.02, 0.1}) {
            const Answer answer = answer_of(sampled(motion, {rate, noise, quantum}, random));
            EXPECT_FALSE(answer.refused) << motion.name << ", " << rate << "/s, noise " << noise << ", " << quantum;
            EXPECT_EQ(answer.count(), 0u) << motion.name << ", " << rate << "/s, noise " << noise << ", " << quantum;
          }
}

TEST(MixedRows, GlitchesAreFoundAlsoWhereTheyAreMany) {
  for (const auto& [chance, least] : {std::pair{0.002, 0.93}, {0.01, 0.85}, {0.05, 0.8}, {0.1, 0.8}}) {
    const Rates rates = rates_of(
        [chance = chance](MixedColumn& column, std::mt19937& random) { add_glitches(chance, column, random); });
    EXPECT_GT(rates.right_share(), least) << chance;
    EXPECT_LT(rates.lost_share(), 1e-4) << chance;
  }
}

TEST(MixedRows, SoManyGlitchesThatNothingIsSureAreRefused) {
  const Rates rates = rates_of([](MixedColumn& column, std::mt19937& random) { add_glitches(0.25, column, random); });
  EXPECT_GT(rates.refused, rates.columns * 2 / 3);
}

TEST(MixedRows, ZerosOfASecondPublisherAreFound) {
  for (const std::size_t every : {3u, 5u, 10u})
    for (const bool irregular : {false, true}) {
      const Rates rates = rates_with(kZeros, every, irregular);
      EXPECT_GT(rates.right_share(), 0.85) << every << irregular;
      EXPECT_LT(rates.lost_share(), 0.005) << every << irregular;
      EXPECT_LT(rates.refused, 5) << every << irregular;
    }
}

/// Where the courses cross, some of their rows may be taken for the other's.
TEST(MixedRows, RowsOfAnotherJointAreFound) {
  for (const std::size_t every : {3u, 5u})
    for (const bool irregular : {false, true}) {
      const Rates rates = rates_with(kOtherJoint, every, irregular);
      EXPECT_GT(rates.right_share(), 0.6) << every << irregular;
      EXPECT_LT(rates.lost_share(), 0.015) << every << irregular;
    }
}

TEST(MixedRows, TwoCoursesOfWhichEitherMayBeRightAreRefused) {
  for (const auto& other : {std::function<double(double)>(kZeros), std::function<double(double)>(kOtherJoint)}) {
    const Rates rates = rates_with(other, 1, false);
    EXPECT_GT(rates.refused, rates.columns * 9 / 10);
  }
}

class MixedFile : public testing::Test {
 protected:
  RecordingSource source_of(const MixedColumn& column, const std::function<double(std::size_t)>& torque) {
    std::string text = "t,q,u\n";
    for (std::size_t i = 0; i < column.times.size(); ++i)
      text += fmt::format("{},{},{}\n", column.times[i], column.values[i], torque(i));
    return pendulum_source(folder_.write("run.csv", text));
  }
  static MixedColumn swing(double noise = 1e-3) {
    std::mt19937 random(3);
    return sampled(test_motions().front(), {100.0, noise}, random);
  }
  static MixedColumn swing_between(const std::function<double(double)>& other, std::size_t every) {
    std::mt19937 random(3);
    MixedColumn column = swing();
    add_rows_between(other, every, false, column, random);
    return column;
  }
  static double torque(std::size_t i) { return std::sin(0.03 * static_cast<double>(i)); }

  TestFolder folder_;
};

TEST_F(MixedFile, SixGlitchesAmongSixHundredRowsAreCountedAndLeftOut) {
  MixedColumn column = swing();
  for (const std::size_t i : {60u, 150u, 151u, 290u, 400u, 510u}) column.values[i] += 3.0;
  const Recording recording = read_pendulum(source_of(column, torque));
  EXPECT_THAT(notes_of(recording), HasSubstr("run.csv:62: column `q`: 6 of 600 readings (1 %), at 0.6 s, 1.5 s, 1.51 s "
                                             "and 3 more times, leave the signal by far"));
  for (const std::size_t i : {60u, 150u, 151u, 290u, 400u, 510u})
    EXPECT_TRUE(std::isnan(recording.trials.front().measured.samples(static_cast<Eigen::Index>(i), 0))) << i;
}

TEST_F(MixedFile, ZerosBetweenAreCountedAndLeftOut) {
  const MixedColumn column = swing_between(kZeros, 5);
  const Recording recording = read_pendulum(source_of(column, torque));
  EXPECT_THAT(
      notes_of(recording),
      HasSubstr("run.csv:7: column `q`: 119 of 719 readings (17 %), at 0.0425 s, 0.0925 s, 0.1425 s and 116 more "
                "times, are left out with their rows. They are 0.00 rad between the others"));
  for (const std::size_t i : column.bad)
    EXPECT_TRUE(std::isnan(recording.trials.front().measured.samples(static_cast<Eigen::Index>(i), 0))) << i;
}

/// The rows of the other joint hold its command.
TEST_F(MixedFile, CommandsOfSuchRowsAreNotApplied) {
  const MixedColumn column = swing_between(kZeros, 5);
  const auto with_zeros = [&](std::size_t i) {
    return std::binary_search(column.bad.begin(), column.bad.end(), i) ? 0.0 : 2.0 + torque(i);
  };
  const Recording recording = read_pendulum(source_of(column, with_zeros));
  EXPECT_GT(recording.trials.front().commands.series.samples.minCoeff(), 0.5);
}

TEST_F(MixedFile, TwoCoursesOfEqualNumberAreRefusedWithWhatToDo) {
  const RecordingSource source = source_of(swing_between(kOtherJoint, 1), torque);
  EXPECT_THAT(complaint_of(source), HasSubstr("column `q` contains two series: "));
  EXPECT_THAT(complaint_of(source), HasSubstr("delete the rows of the other one"));
}

TEST_F(MixedFile, KeptReadingsAreCompared) {
  RecordingSource source = source_of(swing_between(kOtherJoint, 1), torque);
  source.sensors.front().keeps_glitches = true;
  const Recording recording = read_pendulum(source);
  EXPECT_TRUE(recording.trials.front().measured.samples.allFinite());
  EXPECT_THAT(notes_of(recording), Not(HasSubstr("two courses")));
}

TEST_F(MixedFile, AJointThatRestsAtExactlyZeroKeepsItsReadings) {
  MixedColumn column = swing(0.0);
  for (std::size_t i = 0; i < column.values.size(); ++i)
    if (i % 200 < 120) column.values[i] = 0.0;
  EXPECT_TRUE(read_pendulum(source_of(column, torque)).trials.front().measured.samples.allFinite());
}

}  // namespace
}  // namespace lacuna
