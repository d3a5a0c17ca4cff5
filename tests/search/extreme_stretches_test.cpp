#include "search/extreme_stretches.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

RobotSpec two_joints() {
  RobotSpec robot;
  robot.joints.resize(2);
  robot.joints[0].name = "shoulder";
  robot.joints[1].name = "elbow";
  robot.actuators.resize(1);
  robot.actuators[0].name = "motor";
  robot.actuators[0].joint = "elbow";
  robot.sensors.resize(2);
  for (std::size_t i = 0; i < 2; ++i) {
    robot.sensors[i].name = i == 0 ? "angle_1" : "angle_2";
    robot.sensors[i].element = robot.joints[i].name;
  }
  return robot;
}

/// 100 samples of two joints, in stretches of 5, 10 and 20 samples. The shoulder is at 0 but for its peak of 9 at
/// sample 33 and its least of −9 at 85; the elbow does not move.
struct Recorded {
  PredictionLadder ladder;
  std::vector<Trial> trials;

  Recorded() {
    Trial& trial = trials.emplace_back();
    trial.measured.samples = TimeSeries::Samples::Zero(100, 2);
    trial.measured.samples(33, 0) = 9.0;
    trial.measured.samples(85, 0) = -9.0;
    ladder.lengths = {0.5, 1.0, 2.0};
    ladder.noise = {{"angle_1", "rad", 1.0, ""}, {"angle_2", "rad", 1.0, ""}};
    ladder.layout.lengths = 3;
    for (std::size_t length = 0; length < 3; ++length)
      for (Eigen::Index size = 5 << length, first = 0; first + size <= 100; first += size) add(length, first, size);
  }
  std::vector<Eigen::Index> for_joint(const std::string& joint) const {
    std::vector<Eigen::Index> firsts;
    for (const PredictedStretch& one : for_sizes(ladder, two_joints(), trials, joint).stretches) {
      EXPECT_EQ(one.length, 1U) << "of the middle length";
      firsts.push_back(one.stretch.first);
    }
    return firsts;
  }

 private:
  void add(std::size_t length, Eigen::Index first, Eigen::Index size) {
    PredictedStretch& stretch = ladder.stretches.emplace_back();
    stretch.length = length;
    stretch.stretch = {0, first, first + size};
    for (Eigen::Index row = 1; row < size; ++row)
      for (Eigen::Index column = 0; column < 2; ++column) {
        stretch.rows.push_back(row);
        stretch.columns.push_back(column);
        stretch.channels.push_back(static_cast<std::size_t>(column));
      }
  }
};

TEST(JointAt, IsTheJointOfAPlaceOrOfAValueThere) {
  EXPECT_EQ(joint_at(two_joints(), "joint.shoulder"), "shoulder");
  EXPECT_EQ(joint_at(two_joints(), "joint.shoulder.damping"), "shoulder");
  EXPECT_EQ(joint_at(two_joints(), "actuator.motor"), "elbow");
  EXPECT_EQ(joint_at(two_joints(), "sensor.angle_1.offset"), "shoulder");
}

TEST(JointAt, IsNoneOfABodyOrTheWorld) {
  EXPECT_EQ(joint_at(two_joints(), "body.arm"), "");
  EXPECT_EQ(joint_at(two_joints(), ""), "");
  EXPECT_EQ(joint_at(two_joints(), "actuator.other"), "");
}

/// There a limit would be reached.
TEST(ForSizes, HasTheStretchesWhereTheJointIsFarthest) {
  EXPECT_THAT(Recorded().for_joint("shoulder"), testing::IsSupersetOf({30, 80}));
}

TEST(ForSizes, HasAFewStretchesWhateverTheJoint) {
  const std::vector<Eigen::Index> few = Recorded().for_joint("");
  EXPECT_EQ(few.size(), 2U);
  EXPECT_LE(Recorded().for_joint("shoulder").size(), few.size() + 4) << "the extremes of four figures at most";
}

TEST(ForSizes, HasTheSteepestRise) {
  Recorded recorded;
  recorded.trials[0].measured.samples.setZero();
  for (Eigen::Index row = 50; row < 60; ++row)
    recorded.trials[0].measured.samples(row, 1) = 0.1 * static_cast<double>(row - 55);  // from −0.5 to 0.4
  recorded.trials[0].measured.samples.col(1).tail(15).setConstant(5.0);
  EXPECT_THAT(recorded.for_joint("elbow"), testing::Contains(50));
}

}  // namespace
}  // namespace lacuna
