#include "simulation/engine/effects.h"
#include "simulation/engine/support.h"
#include "support/sanitizers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>

#if LACUNA_WATCHED
#define LACUNA_COUNTS_ALLOCATIONS 0
#else
#define LACUNA_COUNTS_ALLOCATIONS 1
#endif

#if LACUNA_COUNTS_ALLOCATIONS
namespace {
std::atomic<long> allocations{0};
}  // namespace

// ODE allocates with malloc and realloc, C++ with operator new, which ends in malloc: these see all.
extern "C" {
void* __libc_malloc(std::size_t size);                     // NOLINT
void* __libc_calloc(std::size_t count, std::size_t size);  // NOLINT
void* __libc_realloc(void* memory, std::size_t size);      // NOLINT
void* malloc(std::size_t size) {
  ++allocations;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  ++allocations;
  return __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) {
  ++allocations;
  return __libc_realloc(memory, size);
}
}
#endif

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

#if LACUNA_COUNTS_ALLOCATIONS
/// Allocations of a whole simulation in a workspace and result that were used before.
long allocations_of(Rig& rig, const lacuna::Test& test, double duration) {
  const std::vector<double> times{0.0, 0.011, 0.5 * duration, duration};
  rig.run(test, times);
  EXPECT_GT(allocations, 1000);  // compiling took some: the counter counts
  const long before = allocations;
  rig.model->simulate({}, test, rig.options, *rig.workspace, rig.result);
  EXPECT_EQ(rig.result.ending, Ending::completed) << rig.result.reason;
  return allocations - before;
}

void expect_none_in_a_step(const lacuna::Test& test) {
  const WearingFriction wear;
  const Lag lag(true);
  Rig rig(ModelStructure{.robot = everything(),
                         .effects = {place("wear", wear, ElementKind::joint, {0}, {0.05}),
                                     place("lag", lag, ElementKind::actuator, {1}, {0.3})},
                         .parameters = {}},
          step_of(0.001));
  rig.options.stop_when = [](std::size_t, std::span<const double>) { return false; };
  EXPECT_EQ(allocations_of(rig, test, 0.1), allocations_of(rig, test, 1.0));
}
#endif

TEST(Allocation, NoneInAStepUnderRecordedCommands) {
#if LACUNA_COUNTS_ALLOCATIONS
  expect_none_in_a_step(shake());
#else
  GTEST_SKIP() << "the sanitizer has its own allocator";
#endif
}

TEST(Allocation, NoneInAStepInClosedLoop) {
#if LACUNA_COUNTS_ALLOCATIONS
  lacuna::Test test;
  test.drive = std::make_shared<const Nod>();
  expect_none_in_a_step(test);
#else
  GTEST_SKIP() << "the sanitizer has its own allocator";
#endif
}

TEST(Allocation, NoneWhenContactsAppearForTheFirstTime) {
#if LACUNA_COUNTS_ALLOCATIONS
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
    const long before = allocations;
    rig.model->simulate({}, test, rig.options, *rig.workspace, rig.result);
    EXPECT_EQ(rig.result.ending, Ending::completed) << rig.result.reason;
    return allocations - before;
  };
  EXPECT_EQ(count(0.1), count(1.5));
#else
  GTEST_SKIP() << "the sanitizer has its own allocator";
#endif
}

}  // namespace
}  // namespace lacuna::testing
