#include "residual_law/joint_course.h"

#include "residual_law/pendulum_data.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna {
namespace {

constexpr double kStepAt = 3.0;  // s
double one_step(double t) { return t < kStepAt ? 0.1 : 0.4; }

/// A pendulum under one step of its command, and a recording that is held out.
const PendulumData& stepped() {
  static const PendulumData data([] {
    const PendulumTruth truth{.inertia = kModelInertia, .damping = 0.1};
    std::vector<Trial> trials = {recorded(truth, "step.csv", one_step, 6.0, 1),
                                 recorded(truth, "held.csv", one_step, 6.0, 2)};
    trials[1].held_out = true;
    return trials;
  }());
  return data;
}

const JointCourse& course() {
  static const JointCourse only = joint_courses(stepped().data()).at(0);
  return only;
}

TEST(JointCourses, NameTheJointAndItsUnits) {
  ASSERT_EQ(joint_courses(stepped().data()).size(), 1U);
  EXPECT_EQ(course().joint, "hinge");
  EXPECT_EQ(course().position_unit, "rad");
  EXPECT_EQ(course().force_unit, "N*m");
  EXPECT_EQ(course().command_unit, "N*m");
}

TEST(JointCourses, AreEmptyOfWhatIsHeldOut) {
  ASSERT_EQ(course().trials.size(), 2U);
  EXPECT_EQ(course().trials[0].size(), 601U);
  EXPECT_TRUE(course().trials[1].empty());
}

/// Near its end it hangs at rest where gravity holds 0.4 N·m.
TEST(JointCourses, AreTheMotionThatTheReadingsTell) {
  const JointMoment last = course().trials[0].back();
  EXPECT_NEAR(last.time, 6.0, 1e-9);
  EXPECT_NEAR(last.command, 0.4, 1e-12);
  double swing = 0.0;
  for (const JointMoment& moment : course().trials[0]) swing = std::max(swing, std::abs(moment.velocity));
  EXPECT_GT(swing, 0.5);
  const std::vector<JointMoment>& moments = course().trials[0];
  for (std::size_t i = 100; i < 550; i += 50)
    EXPECT_NEAR(moments[i].velocity, (moments[i + 1].position - moments[i - 1].position) / 0.02, 0.1) << i;
}

/// A first-order low-pass with each time constant after the step.
TEST(JointCourses, RememberTheCommandWithTheTimeConstantsOfTheLengths) {
  const std::vector<double>& lengths = stepped().data().ladder().lengths;
  const std::array<double, kMemories> constants = {lengths.front(), std::sqrt(lengths.front() * lengths.back()),
                                                   lengths.back()};
  const std::vector<JointMoment>& moments = course().trials[0];
  for (std::size_t m = 0; m < kMemories; ++m) {
    EXPECT_NEAR(moments[299].slow_command[m], 0.1, 1e-9) << "steady until the step";
    const double since = moments[330].time - moments[299].time;
    EXPECT_NEAR(moments[330].slow_command[m], 0.4 - 0.3 * std::exp(-since / constants[m]), 1e-9) << m;
  }
}

TEST(JointCourses, RememberTheDirectionOfMotion) {
  for (const JointMoment& moment : course().trials[0])
    for (const double slow : moment.slow_direction) EXPECT_LE(std::abs(slow), 1.0);
  EXPECT_EQ(course().trials[0][0].slow_direction[0], course().trials[0][0].velocity > 0.0 ? 1.0 : -1.0);
}

TEST(JointCourses, GiveAllValuesOfAQuantity) {
  JointCourse two{"hinge", "rad", "N*m", "", {{{.position = 1.0}}, {}, {{.position = 2.0}, {.position = 3.0}}}};
  EXPECT_THAT(two.all(&JointMoment::position), testing::ElementsAre(1.0, 2.0, 3.0));
}

}  // namespace
}  // namespace lacuna
