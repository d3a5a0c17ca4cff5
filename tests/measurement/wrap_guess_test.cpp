#include "measurement/series/wrap_guess.h"
#include "measurement/trials/encoding_guess.h"

#include "measurement_fixture.h"

#include <fmt/format.h>

#include <cmath>
#include <random>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

using Columns = std::vector<std::vector<double>>;

constexpr double kCounts[] = {256,  360,  500,  512,  720,   1000,   1024,   2000,   2048,    3600,
                              4000, 4096, 8000, 8192, 20000, 131072, 262144, 524288, 1048576, 2097152};

/// A turning joint by a counter that starts again.
struct WrappingCounter {
  double modulus = 1000.0;
  double step = 10.0;  // counts from reading to reading, at most
  bool swings = false;
  bool is_signed = false;
  double noise = 0.0;  // counts
  double direction = 1.0;
  unsigned seed = 1;
  int readings = 600;

  std::vector<double> positions() const {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> anywhere(0.0, 1.0);
    std::normal_distribution<double> error(0.0, std::max(noise, 1e-9));
    const double phase = 2.0 * M_PI * anywhere(random);
    double position = modulus * anywhere(random);
    std::vector<double> result;
    for (int i = 0; i < readings; ++i) {
      const double speed = swings ? 0.6 * std::sin(0.03 * i + phase) + 0.4 * std::sin(0.0811 * i)
                                  : 1.0 - 0.1 * std::sin(0.013 * i + phase);
      position += direction * step * speed;
      result.push_back(std::round(position + error(random)));
    }
    return result;
  }

  std::vector<double> readings_of() const {
    std::vector<double> result = positions();
    for (double& value : result) {
      value -= modulus * std::floor(value / modulus);
      if (is_signed && value >= 0.5 * modulus) value -= modulus;
    }
    return result;
  }
};

/// The count that is found: 0, none; negative: not told apart.
double found_count(const Columns& files, const std::vector<double>& turns = {}) {
  const std::optional<FoundWrap> found = find_wrap(files, turns);
  if (!found) return 0.0;
  return found->is_certain ? found->moduli.front() : -found->estimate;
}

TEST(Wraps, AreFoundAtTheirOwnCount) {
  for (const double modulus : kCounts)
    for (const double share : {0.01, 0.06, 0.23})
      for (const bool is_signed : {false, true})
        for (const double direction : {1.0, -1.0}) {
          const WrappingCounter turns{
              .modulus = modulus, .step = share * modulus, .is_signed = is_signed, .direction = direction};
          EXPECT_EQ(found_count({turns.readings_of()}), modulus) << share << is_signed << direction;
        }
}

TEST(Wraps, AreFoundInASwing) {
  for (const double modulus : kCounts)
    for (const double share : {0.04, 0.15})
      for (const bool is_signed : {false, true}) {
        const WrappingCounter swings{
            .modulus = modulus, .step = share * modulus, .swings = true, .is_signed = is_signed};
        EXPECT_EQ(found_count({swings.readings_of()}), modulus) << share << is_signed;
      }
}

/// Noise of a tenth of a step leads to and fro over the count; what cannot be told apart then is said.
TEST(Wraps, AreNeverTakenForOthersInNoise) {
  int found = 0, all = 0;
  for (const double modulus : kCounts)
    for (const double share : {0.003, 0.03, 0.2})
      for (unsigned seed = 1; seed <= 3; ++seed) {
        const WrappingCounter noisy{
            .modulus = modulus, .step = share * modulus, .noise = std::max(1.0, 0.1 * share * modulus), .seed = seed};
        const double count = found_count({noisy.readings_of()});
        EXPECT_TRUE(count <= 0.0 || count == modulus) << modulus << " as " << count << ", seed " << seed;
        found += count == modulus ? 1 : 0;
        ++all;
      }
  EXPECT_GT(found, 0.9 * all);
}

/// Three readings on either side of one jump, at a speed that is not even, do not tell 1000 from 1024.
TEST(Wraps, SayWhatCannotBeToldApart) {
  const WrappingCounter noisy{.modulus = 1000.0, .step = 60.0, .noise = 12.0, .readings = 60};
  const std::optional<FoundWrap> found = find_wrap(Columns{noisy.readings_of()}, {});
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->is_certain);
  EXPECT_THAT(found->moduli, AllOf(Contains(1000.0), Contains(1024.0)));
  EXPECT_EQ(found_count({noisy.readings_of()}, {1000.0}), 1000.0) << "the experiment knows the counts of a turn";
}

/// A counter on the motor's side of a gear, and one of several turns.
TEST(Wraps, KnowPartsAndMultiplesOfATurn) {
  for (const double modulus : {1103.0, 2206.0, 4412.0}) {
    const WrappingCounter turns{.modulus = modulus, .step = 0.04 * modulus};
    EXPECT_EQ(found_count({turns.readings_of()}, {2206.0}), modulus);
  }
}

TEST(Wraps, AMotionWithoutAnyShowsNone) {
  for (const double modulus : kCounts)
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const WrappingCounter swings{
          .modulus = modulus, .step = 0.01 * modulus, .swings = true, .noise = 1.0, .seed = seed};
      EXPECT_EQ(found_count({swings.positions()}), 0.0) << modulus;
      const WrappingCounter turns{.modulus = modulus, .step = 0.1 * modulus, .seed = seed};
      EXPECT_EQ(found_count({turns.positions()}), 0.0) << modulus;
    }
}

/// Readings of 0 or of the highest number, readings with a bit turned over, random ones: no counter does that.
TEST(Wraps, GlitchesShowNone) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> anywhere(0.0, 4096.0);
  const std::vector<double> motion =
      WrappingCounter{.modulus = 4096.0, .step = 8.0, .swings = true, .seed = 2}.positions();
  Columns zeros{motion}, highest{motion}, bits{motion}, wild{motion};
  for (std::size_t i = 7; i < motion.size(); i += 40) {
    zeros[0][i] = 0.0;
    highest[0][i] = 65535.0;
    bits[0][i] += 2048.0;
    wild[0][i] = std::round(anywhere(random));
  }
  for (const Columns& column : {zeros, highest, bits, wild}) EXPECT_EQ(found_count(column, {4096.0}), 0.0);
}

TEST(Wraps, StepsAndHomingShowNone) {
  std::vector<double> steps, homed, noise;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(0.0, 1000.0);
  for (int i = 0; i < 600; ++i) {
    steps.push_back(std::round(900.0 * ((i / 40) % 2) + 20.0 * std::sin(0.2 * i)));
    homed.push_back(i < 300 ? 4521.0 - i : std::round(40.0 * std::sin(0.02 * i)));
    noise.push_back(std::round(anywhere(random)));
  }
  for (const auto& column : {steps, homed, noise}) EXPECT_EQ(found_count({column}, {4096.0, 1000.0}), 0.0);
}

TEST(Wraps, AFewGlitchesHideNone) {
  std::vector<double> readings = WrappingCounter{.modulus = 3600.0, .step = 40.0, .readings = 3000}.readings_of();
  for (const std::size_t i : {50U, 311U, 420U}) readings[i] = std::fmod(readings[i] + 1500.0, 3600.0);
  EXPECT_EQ(found_count({readings}), 3600.0);
}

/// Speed and load of a servo's registers.
TEST(SignBits, AreFoundWhereverTheyAre) {
  for (const int bit : {7, 8, 9, 10, 11, 12, 13, 14, 15, 31})
    for (const double noise : {0.0, 0.01}) {
      std::mt19937 random(static_cast<unsigned>(bit));
      const double size = std::ldexp(1.0, bit);
      std::normal_distribution<double> error(0.0, std::max(noise * size, 1e-9));
      Columns column(1);
      for (int i = 0; i < 800; ++i) {
        const double value = std::round(0.6 * size * std::sin(0.03 * i) + error(random));
        column[0].push_back(value < 0.0 ? size - value : value);
      }
      const auto found = guess_encoding(column, {false, {}});
      ASSERT_TRUE(found) << bit << " " << noise;
      EXPECT_EQ(found->encoding, (Encoding{EncodingKind::sign_bit, size}));
    }
}

/// A load near zero changes its sign at every third reading.
TEST(SignBits, AreFoundInALoadAboutZero) {
  std::mt19937 random(9);
  std::normal_distribution<double> load(0.0, 12.0);
  Columns column(1);
  for (int i = 0; i < 800; ++i) {
    const double value = std::round(load(random));
    column[0].push_back(value < 0.0 ? 1024.0 - value : value);
  }
  EXPECT_EQ(guess_encoding(column, {false, {}}).value().encoding, (Encoding{EncodingKind::sign_bit, 1024.0}));
}

TEST(SignBits, ASpeedInTwosComplementHasNone) {
  Columns column(1);
  for (int i = 0; i < 800; ++i) {
    const double value = std::round(30000.0 * std::sin(0.02 * i));
    column[0].push_back(value < 0.0 ? 65536.0 + value : value);
  }
  EXPECT_EQ(guess_encoding(column, {false, {}}).value().encoding, (Encoding{EncodingKind::twos_complement, 65536.0}));
}

TEST(SignBits, SizesHaveNone) {
  Columns speeds(1), ramps(1);
  for (int i = 0; i < 800; ++i) {
    speeds[0].push_back(std::round(1800.0 * std::abs(std::sin(0.03 * i))));
    ramps[0].push_back(static_cast<double>((37 * i) % 1900));
  }
  for (const Columns& column : {speeds, ramps}) EXPECT_FALSE(guess_encoding(column, {false, {}}));
}

class CountedFile : public testing::Test {
 protected:
  RecordingSource source(const WrappingCounter& counter, double counts_per_turn) {
    std::string text = "t,q,u\n";
    int row = 0;
    for (const double value : counter.readings_of()) text += fmt::format("{},{},{}\n", 0.01 * row++, value, 0.1);
    RecordingSource source = pendulum_source(folder_.write("run.csv", text));
    source.sensors.front().unit = "1";
    source.sensors.front().gain = 2.0 * M_PI / counts_per_turn;
    source.sensors.front().gain_unit = "rad";
    return source;
  }
  TestFolder folder_;
};

TEST_F(CountedFile, IsReadAtItsOwnCount) {
  const WrappingCounter counter{.modulus = 1000.0, .step = 13.0};
  const Recording recording = read_pendulum(source(counter, 1000.0));
  EXPECT_THAT(notes_of(recording),
              AllOf(HasSubstr("the counter restarts at 1000"), HasSubstr("encoding = \"wraps 1000\"")));
  const auto angles = recording.trials.front().measured.samples.col(0);
  const std::vector<double> positions = counter.positions();
  for (std::size_t i = 0; i < positions.size(); ++i)
    ASSERT_NEAR(angles(static_cast<Eigen::Index>(i)) - angles(0), 2.0 * M_PI * (positions[i] - positions[0]) / 1000.0,
                1e-9)
        << i;
}

TEST_F(CountedFile, IsRefusedWhereItsCountCannotBeTold) {
  const WrappingCounter noisy{.modulus = 1000.0, .step = 60.0, .noise = 12.0, .readings = 60};
  EXPECT_THAT(complaint_of(source(noisy, 777.0)),
              AllOf(HasSubstr("The readings agree with several counts. State the right one in target.sensors.angle: "),
                    HasSubstr("encoding = \"wraps 1000\" or encoding = \"wraps 2^10\"")));
  EXPECT_THAT(complaint_of(source(noisy, 1000.0)), IsEmpty());
}

}  // namespace
}  // namespace lacuna
