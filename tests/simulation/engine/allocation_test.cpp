#include "simulation/engine/effects.h"
#include "simulation/engine/support.h"
#include "support/allocation_counter.h"

#include <gtest/gtest.h>

namespace lacuna::testing {
namespace {

class Nod : public Controller {
 public:
  int state_size() const override { return 1; }
  void act(double time, std::span<const double> sensors, std::span<double> state,
           std::span<double> commands) const override {
    state[0] += sensors[0];
    commands[0] = 0.5 * std::sin(7.0 * time);
  }
};

/// Allocations of a whole simulation in a workspace and result that were used before.
long allocations_of(Rig& rig, const lacuna::Test& test, double duration) {
  const std::vector<double> times{0.0, 0.011, 0.5 * duration, duration};
  rig.run(test, times);
  EXPECT_GT(allocations(), 500);  // compiling took some: the counter counts
  const long before = allocations();
  rig.model->simulate({}, test, rig.options, *rig.workspace, rig.result);
  EXPECT_EQ(rig.result.ending, Ending::completed) << rig.result.reason;
  return allocations() - before;
}

class Allocation : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Engines, Allocation, ::testing::ValuesIn(engines()),
                         [](const auto& test) { return test.param; });

void expect_none_in_a_step(const std::string& engine, const lacuna::Test& test) {
  const WearingFriction wear;
  const Lag lag(true);
  EngineSettings settings = step_of(0.001);
  settings.engine = engine;
  Rig rig(ModelStructure{.robot = everything_for(engine),
                         .effects = {place("wear", wear, ElementKind::joint, {0}, {0.05}),
                                     place("lag", lag, ElementKind::actuator, {1}, {0.3})},
                         .parameters = {}},
          settings);
  rig.options.stop_when = [](std::size_t, std::span<const double>) { return false; };
  EXPECT_EQ(allocations_of(rig, test, 0.1), allocations_of(rig, test, 1.0));
}

TEST_P(Allocation, NoneInAStepUnderRecordedCommands) {
  if (!kCountsAllocations) GTEST_SKIP() << kOwnAllocator;
  expect_none_in_a_step(GetParam(), shake());
}

TEST_P(Allocation, NoneInAStepInClosedLoop) {
  if (!kCountsAllocations) GTEST_SKIP() << kOwnAllocator;
  lacuna::Test test;
  test.drive = std::make_shared<const Nod>();
  expect_none_in_a_step(GetParam(), test);
}

TEST(AllocationWithOde, NoneWhenContactsAppearForTheFirstTime) {
  if (!kCountsAllocations) GTEST_SKIP() << kOwnAllocator;
  RobotSpec robot = everything();
  robot.contact.slope = 0.0;
  for (BodySpec& body : robot.bodies) body.position.z() += 1.0;
  for (JointSpec& joint : robot.joints) joint.anchor.z() += 1.0;
  const lacuna::Test test = shake();
  // Fresh workspaces: one never meets the ground, the other meets it after 0.45 s.
  const auto count = [&](double duration) {
    Rig rig(robot, step_of(0.001));
    rig.run(test, {0.002});
    const std::vector<double> times{duration};
    rig.options.output_times = times;
    rig.options.end_time = duration;
    const long before = allocations();
    rig.model->simulate({}, test, rig.options, *rig.workspace, rig.result);
    EXPECT_EQ(rig.result.ending, Ending::completed) << rig.result.reason;
    return allocations() - before;
  };
  EXPECT_EQ(count(0.1), count(1.5));
}

}  // namespace
}  // namespace lacuna::testing
