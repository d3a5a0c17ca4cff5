#include "measurement/series/event_counter.h"

#include "measurement_fixture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr double kInterval = 0.01;  // s
constexpr double kTurn = 2.0 * M_PI;
constexpr double kCoarse = 0.3;  // rad

/// A wheel that runs down, from 2 turns a second.
double spin_down(double t) { return kTurn * (2.0 * t - 0.04 * t * t) + 1.234; }
/// One that goes to and fro over some turns.
double to_and_fro(double t) { return kTurn * 6.0 * std::sin(0.25 * t); }

struct Read {
  std::vector<double> times, values;
};

Read counted(const auto& angle, double per_turn, int rows = 2000) {
  Read read;
  for (int i = 0; i < rows; ++i) {
    read.times.push_back(kInterval * i);
    read.values.push_back(kTurn / per_turn * std::floor(angle(kInterval * i) * per_turn / kTurn));
  }
  return read;
}

TEST(EventCounter, ReadsTheMomentsOfItsCounts) {
  for (const double per_turn : {1.0, 2.0, 5.0})
    for (const auto& angle : {spin_down, to_and_fro}) {
      const Read read = counted(angle, per_turn);
      const EventCounter counter = find_events(read.times, read.values, kCoarse);
      ASSERT_GT(counter.events.size(), 12U) << per_turn;
      EXPECT_NEAR(counter.count, kTurn / per_turn, 1e-9);
      double squares = 0.0, claimed = 0.0;
      for (const CountedEvent& event : counter.events) {
        const double error = event.position - angle(read.times[event.row]);
        squares += error * error;
        claimed += event.deviation * event.deviation;
        EXPECT_LT(std::abs(error), 0.75 * kInterval * kTurn * 2.0) << "more than a row's motion";
      }
      EXPECT_NEAR(std::sqrt(squares / claimed), 1.0, 0.35) << per_turn;
      EXPECT_LT(std::sqrt(squares / static_cast<double>(counter.events.size())), 0.2 * counter.count / std::sqrt(12.0));
    }
}

/// The same numbers but for their unit: 4096 counts a turn, which creep.
TEST(EventCounter, AnEncoderThatMovesSlowlyIsNone) {
  const auto creep = [](double t) { return spin_down(t) / 4096.0; };
  const auto swing = [](double t) { return 0.02 * std::sin(0.3 * t); };
  for (const Read& read : {counted(creep, 4096.0), counted(swing, 4096.0), counted(swing, 360.0)})
    EXPECT_THAT(find_events(read.times, read.values, kCoarse).events, IsEmpty());
}

TEST(EventCounter, OthersThatStandStillAreNone) {
  Read switched = counted(spin_down, 1.0), fast = counted([](double t) { return 40.0 * spin_down(t); }, 1.0);
  Read slow_log = switched, noisy = switched;
  for (std::size_t i = 0; i < switched.values.size(); ++i) {
    const double t = switched.times[i];
    switched.values[i] = std::sin(2.0 * t) > 0.0 ? 1.0 : 0.0;
    slow_log.values[i] = spin_down(0.2 * std::floor(t / 0.2));
    noisy.values[i] += 0.01 * std::sin(12.9 * static_cast<double>(i * i));
  }
  for (const Read& read : {switched, fast, slow_log, noisy})
    EXPECT_THAT(find_events(read.times, read.values, kCoarse).events, IsEmpty());
}

class TurnCounter : public testing::Test {
 protected:
  RecordingSource source(const auto& angle, double per_turn) {
    std::string text = "t,q,u\n";
    const Read read = counted(angle, per_turn);
    for (std::size_t i = 0; i < read.times.size(); ++i)
      text +=
          fmt::format("{:.2f},{:.0f},{}\n", read.times[i], read.values[i] * per_turn / kTurn, std::sin(read.times[i]));
    RecordingSource source = pendulum_source(folder_.write("run.csv", text));
    source.sensors.front().unit = "1";
    source.sensors.front().gain = kTurn / per_turn;
    source.sensors.front().gain_unit = "rad";
    source.initial["hinge"].joint = {InitialKnowledge::free, 0.0, 10.0};
    return source;
  }
  TestFolder folder_;
};

TEST_F(TurnCounter, IsComparedAtItsCountsOnly) {
  const Recording recording = read_pendulum(source(spin_down, 1.0));
  EXPECT_THAT(notes_of(recording),
              AllOf(HasSubstr("column `q` counts events: it changes by one count (6.28 rad) at a time"),
                    HasSubstr("keep = [\"repeats\"] in target.sensors.angle uses all rows")));
  const Trial& trial = recording.trials.front();
  int readings = 0;
  for (Eigen::Index i = 0; i < trial.measured.times.size(); ++i) {
    const double value = trial.measured.samples(i, 0);
    if (std::isnan(value)) continue;
    ++readings;
    EXPECT_NEAR(value, spin_down(trial.measured.times(i)), 0.75 * kInterval * kTurn * 2.0);
  }
  EXPECT_EQ(readings, 24);
  EXPECT_LT(trial.sensor_noise.front(), 0.05);
}

/// Nothing is read at the start of a trial: without a word on it, it would be taken for rest.
TEST_F(TurnCounter, WithoutAKnownStartIsSaidAndReadAsWritten) {
  RecordingSource unknown = source(spin_down, 1.0);
  unknown.initial.clear();
  const Recording recording = read_pendulum(unknown);
  EXPECT_THAT(notes_of(recording), HasSubstr("state the initial state in target.initial or let it be fitted"));
  EXPECT_FALSE(recording.trials.front().measured.samples.hasNaN());
}

TEST_F(TurnCounter, OfManyCountsOrKeptIsReadAsWritten) {
  EXPECT_THAT(notes_of(read_pendulum(source([](double t) { return spin_down(t) / 300.0; }, 4096.0))),
              Not(HasSubstr("events")));
  RecordingSource kept = source(spin_down, 1.0);
  kept.sensors.front().keeps_repeats = true;
  EXPECT_FALSE(std::isnan(read_pendulum(kept).trials.front().measured.samples(1, 0)));
}

}  // namespace
}  // namespace lacuna
