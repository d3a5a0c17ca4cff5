#include "measurement/cells/decode.h"
#include "measurement/trials/encoding_guess.h"

#include "measurement_fixture.h"

#include <fmt/format.h>

#include <cmath>

namespace lacuna {
namespace {

using testing::DoubleNear;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr int kReadings = 400;

/// Counts of a joint that swings by ±300 with 1 ms between samples.
std::vector<double> swung_counts() {
  std::vector<double> counts;
  for (int i = 0; i < kReadings; ++i) counts.push_back(std::round(300.0 * std::sin(0.03 * i)));
  return counts;
}

std::vector<double> written(const std::vector<double>& counts, const auto& write) {
  std::vector<double> result;
  for (const double count : counts) result.push_back(write(count));
  return result;
}

double sign_bit(double count) { return count < 0.0 ? 32768.0 - count : count; }
double complement(double count) { return count < 0.0 ? 65536.0 + count : count; }
double wrapped(double count) { return std::fmod(5.0 * count + 3900.0 + 4096.0, 4096.0); }

std::string guessed(const std::vector<double>& column, const EncodingHints& hints = {}) {
  const std::vector<std::vector<double>> files = {column};
  const auto found = guess_encoding(files, hints);
  return found ? to_string(found->encoding) : "none";
}

TEST(Encodings, AreReadAsTheyArePrinted) {
  for (const char* text : {"auto", "plain", "sign_bit 2^15", "twos_complement 2^16", "wraps 360"})
    EXPECT_EQ(to_string(parse_encoding(text).value()), text);
  EXPECT_EQ(parse_encoding("wraps 4096").value(), parse_encoding("wraps 2^12").value());
  for (const char* text : {"", "sign_bit", "sign_bit -3", "wraps x", "gray 2^4", "wraps inf"})
    EXPECT_FALSE(parse_encoding(text)) << text;
}

TEST(Encodings, AreFoundAndUndone) {
  const struct {
    std::vector<double> column;
    const char* encoding;
    double shift, scale;
  } cases[] = {{written(swung_counts(), sign_bit), "sign_bit 2^15", 0.0, 1.0},
               {written(swung_counts(), complement), "twos_complement 2^16", 0.0, 1.0},
               {written(swung_counts(), wrapped), "wraps 2^12", 3900.0, 5.0}};
  for (const auto& [column, encoding, shift, scale] : cases) {
    EXPECT_EQ(guessed(column), encoding);
    std::vector<double> decoded = column;
    decode(parse_encoding(encoding).value(), decoded);
    for (int i = 0; i < kReadings; ++i)
      ASSERT_EQ((decoded[static_cast<std::size_t>(i)] - shift) / scale, swung_counts()[static_cast<std::size_t>(i)])
          << encoding << i;
  }
}

/// One file alone never crosses zero: the other tells.
TEST(Encodings, FilesAreLookedAtTogether) {
  std::vector<std::vector<double>> files = {written(swung_counts(), sign_bit), {}};
  for (int i = 0; i < kReadings; ++i) files[1].push_back(sign_bit(-250.0 + std::round(20.0 * std::sin(0.1 * i))));
  EXPECT_EQ(to_string(guess_encoding(files, {}).value().encoding), "sign_bit 2^15");
}

TEST(Encodings, ATurnIsFoundInTheUnitOfTheColumn) {
  std::vector<double> radians, degrees;
  for (int i = 0; i < kReadings; ++i) {
    radians.push_back(std::remainder(0.05 * i, 2.0 * M_PI));
    degrees.push_back(std::fmod(3.0 * i, 360.0));
  }
  EXPECT_EQ(guessed(radians, {true, {2.0 * M_PI}}), to_string(Encoding{EncodingKind::wraps, 2.0 * M_PI}));
  EXPECT_EQ(guessed(degrees, {true, {360.0}}), "wraps 360");
  EXPECT_EQ(guessed(degrees, {false, {360.0}}), "none") << "a speed goes on nowhere else";
}

TEST(Encodings, SignalsThatWereWrittenAsTheyAreHaveNone) {
  std::vector<double> switched, steps, noise, high;
  for (int i = 0; i < kReadings; ++i) {
    switched.push_back((i / 25) % 2 == 0 ? 0.0 : 1023.0);
    steps.push_back(std::round(600.0 * ((i / 40) % 2) + 30.0 * std::sin(0.2 * i)) + 40.0);
    noise.push_back(std::round(500.0 + 500.0 * std::sin(12.9898 * i * i)));
    high.push_back(std::round(40000.0 + 20000.0 * std::sin(0.05 * i)));
  }
  for (const auto& column : {swung_counts(), switched, steps, noise, high}) EXPECT_EQ(guessed(column), "none");
}

/// A servo at rest around half its range, whose log begins with the zero of a register that nobody had written yet.
TEST(Encodings, OneReadingOnTheOtherSideShowsNone) {
  std::vector<double> late = {0.0};
  for (int i = 1; i < kReadings; ++i) late.push_back(2050.0 + std::round(300.0 * (1.0 - std::cos(0.03 * i))));
  EXPECT_EQ(guessed(late), "none");
  std::vector<double> high = {0.0};
  for (int i = 1; i < kReadings; ++i) high.push_back(4000.0 + std::round(40.0 * std::sin(0.1 * i)));
  EXPECT_EQ(guessed(high), "none");
}

class EncodedFile : public testing::Test {
 protected:
  std::string file(const auto& write, const char* time = nullptr) {
    std::string text = "t,q,u\n";
    for (int i = 0; i < kReadings; ++i)
      text += fmt::format("{},{},{}\n", time ? std::fmod(1000.0 * i + 65000.0, 65536.0) : 0.001 * i,
                          write(swung_counts()[static_cast<std::size_t>(i)]), std::sin(0.01 * i));
    return text;
  }
  Recording read(const std::string& text, const std::string& encoding = "auto", const std::string& unit = "s") {
    RecordingSource source = pendulum_source(folder_.write("run.csv", text));
    source.sensors.front().unit = "1";
    source.sensors.front().gain = 0.001;
    source.sensors.front().gain_unit = "rad";
    source.sensors.front().encoding = parse_encoding(encoding).value();
    source.time_unit = unit;
    return read_pendulum(source);
  }
  TestFolder folder_;
};

TEST_F(EncodedFile, IsReadAsItWasMeantAndSaysSo) {
  const Recording recording = read(file(sign_bit));
  EXPECT_THAT(notes_of(recording),
              HasSubstr("negative values are stored as 32768 + their size; decoded accordingly. State this in "
                        "target.sensors.angle: encoding = \"sign_bit 2^15\""));
  const auto& samples = recording.trials.front().measured.samples;
  for (int i = 0; i < kReadings; ++i)
    ASSERT_THAT(samples(i, 0), DoubleNear(0.001 * swung_counts()[static_cast<std::size_t>(i)], 1e-12));
}

TEST_F(EncodedFile, SaysNothingWhereItIsStated) {
  EXPECT_THAT(notes_of(read(file(sign_bit), "sign_bit 2^15")), Not(HasSubstr("encoding")));
  EXPECT_GT(read(file(sign_bit), "plain").trials.front().measured.samples.maxCoeff(), 32.0);
}

TEST_F(EncodedFile, AClockThatStartsAgainGoesOn) {
  const Recording recording = read(file([](double count) { return count; }, "us"), "auto", "us");
  EXPECT_THAT(
      notes_of(recording),
      HasSubstr("restarts at 65536; its time is continued. State this in target.time: encoding = \"wraps 2^16\""));
  EXPECT_NEAR(recording.trials.front().measured.times(kReadings - 1), 0.001 * (kReadings - 1), 1e-9);
}

TEST_F(EncodedFile, NumbersThatNobodyWroteAreMissing) {
  int row = 0;
  const Recording recording = read(file([&](double count) { return row++ == 7 ? 2.1e-308 : count; }));
  EXPECT_THAT(notes_of(recording),
              HasSubstr("column `q` has 1 number below 1e-290 or beyond 1e30, which no device measures"));
  EXPECT_TRUE(std::isnan(recording.trials.front().measured.samples(7, 0)));
}

}  // namespace
}  // namespace lacuna
