#include "foundation/unit.h"

#include "measurement_fixture.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <functional>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr int kRows = 400;
constexpr double kStep = 0.005;  // s
constexpr double kTolerance = 1e-6;

class Clock : public testing::Test {
 protected:
  /// A file of which each row begins as the clock writes it.
  RecordingSource file(const std::string& header, const std::function<std::string(int)>& stamp,
                       const std::string& column = "t", const std::string& unit = "s") {
    std::string text = header + ";q;u\n";
    for (int i = 0; i < kRows; ++i) text += fmt::format("{};{:.6f};0\n", stamp(i), std::sin(0.05 * i));
    RecordingSource source = pendulum_source(folder_.write("run.csv", text));
    source.time_column = column;
    source.time_unit = unit;
    return source;
  }
  /// All samples at their times, with notes that hold `words`.
  static void expect_read(const RecordingSource& source, const std::string& words = {}) {
    Recording recording;
    ASSERT_NO_THROW(recording = read_pendulum(source)) << complaint_of(source);
    EXPECT_THAT(notes_of(recording), HasSubstr(words));
    const Eigen::VectorXd& times = recording.trials.front().measured.times;
    ASSERT_EQ(times.size(), kRows);
    for (int i = 0; i < kRows; ++i) ASSERT_NEAR(times(i), kStep * i, kTolerance) << i;
  }
  TestFolder folder_;
};

/// A counter of `bits` bits that is one tick on every `1/per_second` s and wraps after some rows.
struct Counter {
  int bits;
  bool is_signed;
  std::int64_t per_second;

  std::int64_t at(int row) const {
    const std::int64_t modulus = std::int64_t{1} << bits, start = is_signed ? modulus / 2 : modulus;
    const std::int64_t count = start - per_second / 4 + per_second / 200 * row;
    return is_signed ? (count + modulus / 2) % modulus - modulus / 2 : count % modulus;
  }
};

TEST_F(Clock, CountersThatStartAgainGoOn) {
  for (const auto& [counter, unit] : {std::pair<Counter, std::string>{{32, true, 1000000}, "us"},
                                      {{32, false, 1000000}, "us"},
                                      {{32, true, 1000}, "ms"},
                                      {{32, false, 1000}, "ms"},
                                      {{16, true, 1000}, "ms"},
                                      {{16, false, 1000}, "ms"},
                                      {{31, false, 1000000}, "us"}}) {
    SCOPED_TRACE(fmt::format("{} bits, signed {}, {}", counter.bits, counter.is_signed, unit));
    expect_read(file(
                    "t", [&counter = counter](int i) { return std::to_string(counter.at(i)); }, "t", unit),
                "restarts at ");
  }
}

TEST_F(Clock, ASignedCounterSaysWhereItGoesOn) {
  const Counter counter{32, true, 1000000};
  expect_read(file(
                  "t", [&](int i) { return std::to_string(counter.at(i)); }, "t", "us"),
              "restarts at 2147483648 from -2147483648 on; its time is continued. State this in target.time: encoding "
              "= \"wraps 2^32\"");
}

/// Divided by the logger.
TEST_F(Clock, CountersOfMicrosecondsWrittenInSecondsGoOn) {
  for (const bool is_signed : {true, false}) {
    const Counter counter{32, is_signed, 1000000};
    expect_read(file("t", [&](int i) { return fmt::format("{:.6f}", 1e-6 * static_cast<double>(counter.at(i))); }),
                "restarts at ");
  }
}

TEST_F(Clock, TimesSinceMidnightGoOn) {
  for (const auto& [unit, per_second] : {std::pair<std::string, double>{"s", 1.0}, {"ms", 1e3}, {"us", 1e6}}) {
    const auto stamp = [per_second = per_second](int i) {
      return fmt::format("{:.3f}", per_second * std::fmod(86399.0 + kStep * i + 1e-7, 86400.0));
    };
    expect_read(file("t", stamp, "t", unit), "restarts at ");
  }
}

std::string time_of_day(int milliseconds, const char* layout) {
  const int ms = milliseconds % 1000, s = milliseconds / 1000 % 60, min = milliseconds / 60000 % 60,
            h = milliseconds / 3600000 % 24;
  const std::string_view text = layout;
  if (text == "12")
    return fmt::format("{}:{:02}:{:02}.{:03} {}", h % 12 == 0 ? 12 : h % 12, min, s, ms, h < 12 ? "AM" : "PM");
  if (text == "12 bare") return fmt::format("{:02}:{:02}:{:02}.{:03}", h % 12 == 0 ? 12 : h % 12, min, s, ms);
  if (text == "minutes") return fmt::format("{:02}:{:02}.{:03}", min, s, ms);
  return fmt::format("{:02}:{:02}:{:02}{}{:03}", h, min, s, layout, ms);
}

constexpr int kOne = 3600 * 1000;  // ms after midnight

TEST_F(Clock, TimesOfDayAreRead) {
  for (const char* layout : {".", ",", ":", "12", "minutes"})
    expect_read(file("t", [&](int i) { return time_of_day(12 * kOne + 59 * 60000 + 57005 + 5 * i, layout); }));
}

TEST_F(Clock, TimesOfDayGoOnAtMidnight) {
  for (const char* layout : {".", ",", "12"})
    expect_read(file("t", [&](int i) { return time_of_day(24 * kOne - 1000 + 5 * i, layout); }),
                "restarts after 24 h here");
}

TEST_F(Clock, TwelveHoursWithoutTheirHalfGoOnAtOne) {
  expect_read(file("t", [](int i) { return time_of_day(13 * kOne - 1000 + 5 * i, "12 bare"); }),
              "restarts after 12 h here");
}

TEST_F(Clock, MinutesAndSecondsGoOnAtTheHour) {
  expect_read(file("t", [](int i) { return time_of_day(kOne - 1000 + 5 * i, "minutes"); }), "restarts after 1 h here");
}

TEST_F(Clock, TimesThatAreNoneAreRefused) {
  for (const char* bad : {"25:00:00.0", "12:60:00.0", "12:59", "12:59:57.0 XM", "13:00:00.0 PM"}) {
    const RecordingSource source = file("t", [&](int i) { return i == 7 ? bad : time_of_day(kOne + 5 * i, "."); });
    EXPECT_THAT(complaint_of(source), HasSubstr(fmt::format("run.csv:9: column `t` has `{}`", bad)));
  }
}

TEST_F(Clock, SecondsAndTheirPartsInTwoColumnsAreOneTime) {
  for (const auto& [seconds, parts, unit] : {std::tuple<std::string, std::string, int>{"sec", "nanosec", 1000000000},
                                             {"header.stamp.secs", "header.stamp.nsecs", 1000000000},
                                             {"tv_sec", "tv_usec", 1000000},
                                             {"stamp_s", "stamp_ns", 1000000000},
                                             {"Secs", "Msec", 1000}}) {
    const auto stamp = [unit = unit](int i) {
      const std::int64_t parts_since = (900 + 5 * i) * (std::int64_t{unit} / 1000);
      return fmt::format("{};{}", 1700000000 + parts_since / unit, parts_since % unit);
    };
    expect_read(file(fmt::format("{};{}", seconds, parts), stamp, seconds),
                fmt::format("time stamps are the seconds in column `{}`", seconds));
  }
}

/// A time in two units is no time in two parts.
TEST_F(Clock, SecondsThatAreNotWholeAreAllThereIs) {
  const auto stamp = [](int i) { return fmt::format("{:.3f};{}", kStep * i, 5 * i % 1000); };
  const RecordingSource source = file("stamp_s;stamp_ms", stamp, "stamp_s");
  expect_read(source);
  EXPECT_THAT(notes_of(read_pendulum(source)), Not(HasSubstr("two")));
}

/// A clock of one minute, or trials of one minute each.
TEST_F(Clock, AClockThatMayBeAnotherTrialIsRefusedWithBothWaysOut) {
  RecordingSource source =
      file("t", [](int i) { return fmt::format("{:.3f}", std::fmod(59.0 + kStep * i + 1e-9, 60.0)); });
  EXPECT_THAT(complaint_of(source), HasSubstr("if another trial starts here, give the trials a column"));
  EXPECT_THAT(complaint_of(source), HasSubstr("if the clock restarts every 60 s, write encoding = \"wraps 60\""));
  source.time_encoding = {EncodingKind::wraps, 60.0};
  expect_read(source);
}

TEST_F(Clock, ThePartOfASecondAloneIsRefusedWithItsPeriod) {
  const auto stamp = [](int i) { return std::to_string((900 + 5 * i) % 1000 * 1000000); };
  EXPECT_THAT(complaint_of(file("t", stamp, "t", "ns")), HasSubstr("write encoding = \"wraps 1000000000\""));
}

class NumbersThatAreNone : public testing::TestWithParam<const char*> {
 protected:
  RecordingSource file(bool every_row) {
    std::string text = "t,q,u\n";
    for (int i = 0; i < kRows; ++i)
      text += fmt::format("{:.3f},{},0\n", kStep * i,
                          every_row || i == 7 ? GetParam() : fmt::format("{:.6f}", std::sin(0.05 * i)));
    return pendulum_source(folder_.write("run.csv", text));
  }
  TestFolder folder_;
};

TEST_P(NumbersThatAreNone, AreMissing) {
  const Recording recording = read_pendulum(file(false));
  EXPECT_THAT(notes_of(recording), HasSubstr("run.csv:9: column `q` has 1 number below 1e-290 or beyond 1e30"));
  EXPECT_TRUE(std::isnan(recording.trials.front().measured.samples(7, 0)));
}

TEST_P(NumbersThatAreNone, AreSaidWhereAllRowsHaveThem) {
  const std::string notes = notes_of(read_pendulum(file(true)));
  EXPECT_THAT(notes, HasSubstr("column `q` has 400 numbers below 1e-290 or beyond 1e30"));
  EXPECT_THAT(notes, HasSubstr("column `q` has no value in the whole trial"));
}

INSTANTIATE_TEST_SUITE_P(Sizes, NumbersThatAreNone,
                         testing::Values("1e-308", "5e-324", "-1e-400", "1e300", "-1.7e308", "9.96921e36"));

}  // namespace
}  // namespace lacuna
