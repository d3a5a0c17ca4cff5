#include "measurement/rig_guess.h"
#include "measurement_fixture.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>

namespace lacuna {
namespace {

using testing::HasSubstr;

constexpr double kRadius = 0.31, kPivotX = 0.12, kPivotY = 0.45;  // m

double tracked_swing(double t) { return 0.6 * std::exp(-0.1 * t) * std::cos(5.5 * t); }

/// As Tracker exports a mass: a line above the header, tabs, no units. `angle`: rad from hanging down.
std::string track_of(const std::function<double(double)>& angle, int rows = 150) {
  std::string text = "mass_A\t\t\nt\tx\ty\n";
  for (int i = 0; i < rows; ++i) {
    const double t = i / 30.0, q = angle(t);
    text +=
        fmt::format("{:.6f}\t{:.6f}\t{:.6f}\n", t, kPivotX + kRadius * std::sin(q), kPivotY - kRadius * std::cos(q));
  }
  return text;
}

class TrackedPoints : public testing::Test {
 protected:
  RecordingSource source(const std::string& text) const {
    RecordingSource source = pendulum_source(folder_.write("track.txt", text));
    source.commands.clear();
    source.sensors[0].column = "x";
    source.sensors[0].unit = "m";
    source.sensors[0].track = {"y", {kPivotX, kPivotY}, -0.5 * M_PI};
    return source;
  }
  TestFolder folder_;
};

TEST_F(TrackedPoints, AreAnglesOfAHinge) {
  const Recording recording = read_pendulum(source(track_of(tracked_swing)));
  const TimeSeries& measured = recording.trials.at(0).measured;
  for (Eigen::Index i = 0; i < measured.times.size(); ++i)
    EXPECT_NEAR(measured.samples(i, 0), tracked_swing(measured.times(i)), 1e-5);
}

TEST_F(TrackedPoints, GoOnFromTurnToTurn) {
  const Recording recording = read_pendulum(source(track_of([](double t) { return 5.0 * t; })));
  const TimeSeries& measured = recording.trials.at(0).measured;
  EXPECT_NEAR(measured.samples(measured.times.size() - 1, 0), 5.0 * measured.times(measured.times.size() - 1), 1e-5);
}

TEST_F(TrackedPoints, GiveAChannelInMetresTheDistance) {
  RecordingSource distance = source(track_of(tracked_swing));
  distance.sensors[0].channel = "length";
  const Recording recording = read_recording(distance, std::vector<Channel>{{"length", "m"}}, {});
  EXPECT_NEAR(recording.trials.at(0).measured.samples(40, 0), kRadius, 1e-5);
}

TEST_F(TrackedPoints, AreLengths) {
  RecordingSource degrees = source(track_of(tracked_swing));
  degrees.sensors[0].unit = "deg";
  EXPECT_THAT(complaint_of(degrees), HasSubstr("x and y of a tracked point are lengths"));
  RecordingSource missing = source("t,x\n0,1\n0.1,1\n");
  EXPECT_THAT(complaint_of(missing), HasSubstr("no column `y`"));
}

TEST_F(TrackedPoints, AreFoundByTheirCircle) {
  const RigGuess guess = guess_rig({sample_file(folder_.write("track.txt", track_of(tracked_swing)))}, {});
  ASSERT_EQ(guess.joints.size(), 1U);
  EXPECT_FALSE(guess.joints[0].slides);
  const std::optional<GuessedTrack>& track = guess.joints[0].position->track;
  ASSERT_TRUE(track.has_value());
  EXPECT_EQ(track->other, "y");
  EXPECT_NEAR(track->radius, kRadius, 1e-5);
  EXPECT_NEAR(track->pivot_x, kPivotX, 1e-5);
  EXPECT_NEAR(track->pivot_y, kPivotY, 1e-5);
  EXPECT_TRUE(guess.unused.empty());
}

TEST_F(TrackedPoints, ThatFlyAreNoHinge) {
  std::string text = "t\tx\ty\n";
  for (int i = 0; i < 60; ++i) {
    const double t = i / 60.0;
    text += fmt::format("{:.6f}\t{:.6f}\t{:.6f}\n", t, 1.5 * t, 4.0 * t - 4.9 * t * t);
  }
  const RigGuess guess = guess_rig({sample_file(folder_.write("track.txt", text))}, {});
  for (const GuessedJoint& joint : guess.joints) EXPECT_FALSE(joint.position && joint.position->track);
}

TEST_F(TrackedPoints, MatchTheHingeOfARobot) {
  RobotSpec robot;
  robot.bodies.push_back({});
  robot.bodies[0].name = "bob";
  JointSpec joint;
  joint.name = "pivot";
  joint.child = "bob";
  robot.joints.push_back(joint);
  SensorSpec sensor;
  sensor.name = "swing";
  sensor.kind = SensorKind::joint_position;
  sensor.element = "pivot";
  robot.sensors.push_back(sensor);
  const RigGuess guess = guess_rig({sample_file(folder_.write("track.txt", track_of(tracked_swing)))}, {}, robot);
  ASSERT_EQ(guess.sensors.size(), 1U);
  EXPECT_EQ(guess.sensors[0].column.name, "x");
  const RecordingSource source = source_of(guess, {{"track.txt"}});
  EXPECT_EQ(source.sensors[0].track.other, "y");
}

}  // namespace
}  // namespace lacuna
