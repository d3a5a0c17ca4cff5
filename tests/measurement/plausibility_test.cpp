#include "measurement_fixture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Ten seconds at 100 Hz of a swing of 1 rad at 0.5 Hz, with its velocity.
struct Swing {
  std::function<double(double)> angle = [](double t) { return std::sin(3.1416 * t); };
  std::function<double(double)> rate = [](double t) { return 3.1416 * std::cos(3.1416 * t); };
  std::function<double(double)> torque = [](double t) { return std::cos(2.0 * t); };
  double time_factor = 1.0;
};

class Plausibility : public testing::Test {
 protected:
  RecordingSource recorded(const Swing& swing, const std::string& header = "t,q,u,w") const {
    std::string text = header + "\n";
    for (int i = 0; i <= 1000; ++i) {
      const double t = 0.01 * i;
      text += fmt::format("{},{:.7g},{:.7g},{:.7g}\n", t * swing.time_factor, swing.angle(t), swing.torque(t),
                          swing.rate(t));
    }
    RecordingSource source = pendulum_source(folder_.write("run.csv", text));
    source.sensors.push_back(source.sensors[0]);
    source.sensors[1].channel = "rate";
    source.sensors[1].column = "w";
    source.sensors[1].unit = "rad/s";
    return source;
  }
  static std::string notes(const RecordingSource& source) { return notes_of(read_pendulum(source)); }

  TestFolder folder_;
};

TEST_F(Plausibility, AGoodRecordingGetsNoNote) { EXPECT_EQ(notes(recorded({})), ""); }

TEST_F(Plausibility, DegreesReadAsRadiansAreNoticed) {
  Swing swing;
  swing.angle = [](double t) { return 57.29578 * std::sin(3.1416 * t); };
  EXPECT_THAT(
      notes(recorded(swing)),
      HasSubstr(
          "column `q` reaches 57.3 rad when read in rad; is it in deg? Then write angle = { ..., unit = \"deg\" }"));
  EXPECT_THAT(notes(recorded(swing)), HasSubstr("column `w` against the slope of `q`: 1/57.3 times"));
}

TEST_F(Plausibility, RadiansReadAsDegreesAreNoticed) {
  RecordingSource source = recorded({});
  source.sensors[0].unit = "deg";
  EXPECT_THAT(notes(source), HasSubstr("column `q` moves by only 2 deg; is it in rad?"));
  EXPECT_THAT(notes(source), HasSubstr("column `w` against the slope of `q`: 57.3 times"));
}

TEST_F(Plausibility, MillisecondsReadAsSecondsAreNoticed) {
  Swing swing;
  swing.time_factor = 1000.0;
  EXPECT_THAT(
      notes(recorded(swing)),
      HasSubstr(
          "samples are 10 s apart when column `t` is read in s; is it in ms or us? Then write unit = \"ms\" under "
          "[target.time]"));
  EXPECT_THAT(notes(recorded(swing)), HasSubstr("1000 times: one is in mm, or the time in ms"));
}

TEST_F(Plausibility, AVelocityOfTheOtherSignIsNoticed) {
  Swing swing;
  swing.rate = [](double t) { return -3.1416 * std::cos(3.1416 * t); };
  EXPECT_THAT(notes(recorded(swing)), HasSubstr("column `w` against the slope of `q`: the signs of the two differ"));
}

TEST_F(Plausibility, AConstantSensorIsNoticed) {
  Swing swing;
  swing.angle = [](double) { return 0.5; };
  EXPECT_THAT(notes(recorded(swing)),
              HasSubstr("column `q` stays at 0.500 rad for the whole trial; is the sensor connected?"));
}

TEST_F(Plausibility, ASaturatedSensorIsNoticed) {
  Swing swing;
  swing.angle = [](double t) { return std::clamp(std::sin(3.1416 * t), -1.0, 0.8); };
  EXPECT_THAT(notes(recorded(swing)),
              HasSubstr("column `q` stays at its largest value 0.800 rad for 205 samples, 5 times"));
}

/// What falls to the ground, or runs into a stop, stays there until the recording ends.
TEST_F(Plausibility, AMotionThatEndsIsNotSaturated) {
  Swing swing;
  swing.angle = [](double t) { return std::max(3.0 - 0.5 * t * t, 0.25); };
  swing.rate = [](double t) { return 0.5 * t * t < 2.75 ? -t : 0.0; };
  EXPECT_THAT(notes(recorded(swing)), Not(HasSubstr("saturated")));
}

TEST_F(Plausibility, AnEncoderThatTurnsRoundIsNotSaturated) {
  Swing swing;
  swing.angle = [](double t) { return 0.01 * std::round(100.0 * std::sin(3.1416 * t)); };
  EXPECT_THAT(notes(recorded(swing)), Not(HasSubstr("saturated")));
}

/// Coarse steps and a quick turn: five samples are alike, and the two before and after are far from them.
TEST_F(Plausibility, AQuickTurnOfACoarseEncoderIsNotSaturated) {
  Swing swing;
  swing.angle = [](double t) { return 0.012 * std::round(std::sin(5.0 * t) / 0.012); };
  EXPECT_THAT(notes(recorded(swing)), Not(HasSubstr("saturated")));
}

/// Dry friction stops a joint wherever its command stops, at the largest value too.
TEST_F(Plausibility, AJointThatStopsAnywhereIsNotSaturated) {
  Swing swing;
  swing.angle = [](double t) {
    const double stage = (t < 5.0 ? t : 10.0 - t) / 0.2;
    return 0.1 * (std::floor(stage) + std::min(1.0, 4.0 * (stage - std::floor(stage))));
  };
  EXPECT_THAT(notes(recorded(swing)), Not(HasSubstr("saturated")));
}

TEST_F(Plausibility, AUnitInTheColumnsNameCounts) {
  RecordingSource source = recorded({}, "t,q [deg],u_Nm,w");
  source.sensors[0].column = "q [deg]";
  source.commands[0].column = "u_Nm";
  EXPECT_THAT(notes(source), HasSubstr("run.csv:1: column `q [deg]` has the unit deg in its name but is read in rad"));
  EXPECT_THAT(notes(source), Not(HasSubstr("u_Nm")));
}

TEST_F(Plausibility, AnAngleWithoutUnitIsNoticed) {
  RecordingSource source = recorded({});
  source.sensors[0].unit = "1";
  EXPECT_THAT(notes(source), HasSubstr("column `q` has no unit and is read in rad"));
}

}  // namespace
}  // namespace lacuna
