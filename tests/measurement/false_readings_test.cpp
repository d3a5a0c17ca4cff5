#include "measurement/series/glitches.h"
#include "measurement/series/repeats.h"

#include "measurement_fixture.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

namespace lacuna {
namespace {

using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<double> signal(const auto& of, int samples = 600) {
  std::vector<double> values;
  for (int i = 0; i < samples; ++i) values.push_back(of(i));
  return values;
}

double ripple(int i) { return 2.0 * (std::fmod(std::abs(43758.5453 * std::sin(12.9898 * i)), 1.0) - 0.5); }
double noisy_swing(int i) { return std::sin(0.05 * i) + 0.001 * ripple(i); }

std::vector<std::size_t> glitches_of(const std::vector<double>& values) {
  std::vector<double> times(values.size());
  std::iota(times.begin(), times.end(), 0.0);
  return find_glitches(times, values).readings;
}

TEST(Glitches, ReadingsThatLeaveAndComeBackAreFound) {
  std::vector<double> values = signal(noisy_swing);
  values[100] += 3.0;
  values[300] = values[301] = 0.0 + values[299] - 2.0;
  EXPECT_THAT(glitches_of(values), ElementsAre(100, 300, 301));
}

TEST(Glitches, SignalsThatAreAsTheyAreHaveNone) {
  EXPECT_THAT(glitches_of(signal(noisy_swing)), IsEmpty());
  EXPECT_THAT(glitches_of(signal(ripple)), IsEmpty());
  EXPECT_THAT(glitches_of(signal([](int i) { return i < 300 ? 0.0 : 1.0; })), IsEmpty());           // a step
  EXPECT_THAT(glitches_of(signal([](int i) { return std::abs(std::sin(0.05 * i)); })), IsEmpty());  // impacts
  EXPECT_THAT(glitches_of(signal([](int i) { return std::copysign(1.0, std::sin(0.05 * i)); })), IsEmpty());
  EXPECT_THAT(glitches_of(signal([](int i) { return std::round(4.0 * std::sin(0.02 * i)); })), IsEmpty());
  EXPECT_THAT(glitches_of(signal([](int i) { return i % 50 == 0 ? 1.0 : 0.0; })), IsEmpty());  // too many: the signal
}

TEST(Repeats, ASlowSensorIsFound) {
  const Repeats repeats = find_repeats(signal([](int i) { return noisy_swing(i - i % 5); }));
  EXPECT_EQ(repeats.every, 5u);
  EXPECT_EQ(repeats.repeated.size(), 480u);
  EXPECT_THAT((std::vector(repeats.repeated.begin(), repeats.repeated.begin() + 5)), ElementsAre(1, 2, 3, 4, 6));
}

TEST(Repeats, AlsoOneWithAClockOfItsOwn) {
  const Repeats repeats =
      find_repeats(signal([](int i) { return noisy_swing(static_cast<int>(std::floor(i / 2.4) * 2.4)); }));
  EXPECT_EQ(repeats.every, 2u);
  EXPECT_NEAR(static_cast<double>(repeats.repeated.size()), 350.0, 10.0);
}

TEST(Repeats, AQuantiserAndARestAreNone) {
  EXPECT_EQ(find_repeats(signal(noisy_swing)).every, 0u);
  EXPECT_EQ(find_repeats(signal([](int i) { return std::round(20.0 * std::sin(0.01 * i)); })).every, 0u);
  EXPECT_EQ(find_repeats(signal([](int i) { return std::floor(0.25 * i); })).every, 0u);  // one step every four
  EXPECT_EQ(find_repeats(signal([](int i) { return i < 300 ? 0.0 : noisy_swing(i); })).every, 0u);
}

/// What was not measured in between repeats nothing.
TEST(Repeats, EmptyCellsAreNone) {
  const Repeats repeats = find_repeats(signal([](int i) { return i % 5 == 0 ? noisy_swing(i) : std::nan(""); }));
  EXPECT_EQ(repeats.every, 0u);
}

/// A kick of a rig that is filmed slowly, from rest to rest.
TEST(Glitches, AKickFromRestIsMotion) {
  std::vector<double> kick = signal([](int i) { return 1e-4 * ripple(i); });
  kick[300] = 0.05;
  kick[301] = 0.09;
  kick[302] = 0.04;
  EXPECT_THAT(glitches_of(kick), IsEmpty());
}

class FalseReadings : public testing::Test {
 protected:
  Recording read(const auto& angle, const auto& command) {
    std::string text = "t,q,u\n";
    for (int i = 0; i < 600; ++i) text += fmt::format("{},{},{}\n", 0.01 * i, angle(i), command(i));
    RecordingSource source = pendulum_source(folder_.write("run.csv", text));
    source.sensors.front().unit = "rad";
    change_(source);
    return read_pendulum(source);
  }
  std::function<void(RecordingSource&)> change_ = [](RecordingSource&) {};
  TestFolder folder_;
};

double torque(int i) { return std::sin(0.03 * i); }

TEST_F(FalseReadings, AGlitchIsNamedWithItsTimeAndLeftOut) {
  const auto with_glitch = [](int i) { return noisy_swing(i) + (i == 123 ? 3.0 : 0.0); };
  const Recording recording = read(with_glitch, torque);
  EXPECT_THAT(notes_of(recording),
              ContainsRegex("run.csv:125: column `q` at 1.23 s: [0-9.-]+ rad for 1 reading, [0-9.-]+ rad before"));
  EXPECT_THAT(notes_of(recording), HasSubstr("a glitch, left out; keep = [\"glitches\"] in target.sensors.angle"));
  EXPECT_TRUE(std::isnan(recording.trials.front().measured.samples(123, 0)));
  change_ = [](RecordingSource& source) { source.sensors.front().keeps_glitches = true; };
  EXPECT_FALSE(std::isnan(read(with_glitch, torque).trials.front().measured.samples(123, 0)));
}

TEST_F(FalseReadings, RepeatedReadingsAreUsedOnce) {
  const auto slow = [](int i) { return noisy_swing(i - i % 10); };
  const Recording recording = read(slow, torque);
  EXPECT_THAT(notes_of(recording), HasSubstr("column `q` has a new reading only every 10 rows (0.1 s) and repeats it"));
  EXPECT_TRUE(std::isnan(recording.trials.front().measured.samples(11, 0)));
  EXPECT_FALSE(std::isnan(recording.trials.front().measured.samples(20, 0)));
  change_ = [](RecordingSource& source) { source.sensors.front().keeps_repeats = true; };
  EXPECT_FALSE(std::isnan(read(slow, torque).trials.front().measured.samples(11, 0)));
}

TEST_F(FalseReadings, ACopyAndALostSignAreNoCommands) {
  EXPECT_THAT(notes_of(read(noisy_swing, [](int i) { return 2.5 * noisy_swing(i) - 0.25; })),
              HasSubstr("is a copy of the reading `q`"));
  EXPECT_THAT(notes_of(read(noisy_swing, [](int i) { return std::abs(torque(i)); })), HasSubstr("its sign was lost"));
  EXPECT_THAT(notes_of(read(noisy_swing, torque)), IsEmpty());
  EXPECT_THAT(notes_of(read(noisy_swing, [](int i) { return 1.0 + torque(i); })), IsEmpty());
  EXPECT_THAT(notes_of(read(noisy_swing, [](int i) { return i / 40 % 2 == 0 ? 0.0 : 1.0; })), IsEmpty());
}

}  // namespace
}  // namespace lacuna
