#include "faults/faulty_program.h"
#include "support/sanitizers.h"
#include "support/small_experiment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace lacuna {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr std::uint64_t kMostCalls = 24,
                        kMostAllocations = 12;  ///< of each command, by default; each once and for good

const std::string kTiny =
    small_experiment("0.2", "population = 6, keep = 3, generations = 2", "population = 4, keep = 2, generations = 2");

/// A pendulum that swings out, without a command: a fit of it takes no time.
void write_pendulum(const Program& program) {
  program.write("rig.toml", R"([experiment]
name = "rig"
[target]
kind = "recorded"
files = ["swing.csv"]
[target.time]
column = "t_s"
[target.sensors]
angle = { column = "angle_rad", unit = "rad" }
[model]
file = "arm.toml"
free = { "joint.hinge.damping" = [0.0, 0.2] }
[engine]
step = "10 ms"
[fit]
method = "free_run"
starts = 1
)");
  program.write("arm.toml", R"([robot]
name = "arm"
[body.arm]
mass = 0.5
com = [0.0, 0.0, -0.2]
inertia = [0.005, 0.005, 0.0005]
[joint.hinge]
kind = "hinge"
child = "arm"
axis = "y"
damping = 0.01
[sensor.angle]
joint = "hinge"
kind = "joint_position"
)");
  std::string series = "t_s,angle_rad\n";
  constexpr double kDecay = 0.4, kRate = 6.2;  // 1/s, rad/s
  for (int i = 0; i < 100; ++i) {
    const double t = 0.02 * i;
    series += std::to_string(t) + "," + std::to_string(0.2 * std::exp(-kDecay * t) * std::cos(kRate * t)) + "\n";
  }
  program.write("swing.csv", series);
}

/// It ended by itself: with its work done, or with a sentence that does not blame the program.
void expect_said(const Outcome& outcome) {
  if (outcome.exit_code == 0) return;
  EXPECT_THAT(outcome.exit_code, AnyOf(1, 2, 75)) << outcome.errors;
  EXPECT_THAT(outcome.errors, Not(IsEmpty()));
  for (const char* fault :
       {"fault of the program", "before its work was done", "terminate called", "std::", "exception"})
    EXPECT_THAT(outcome.errors, Not(HasSubstr(fault)));
}

/// A file that was not begun may be missing, or empty.
void expect_sound(const Program& program, const std::string& database) {
  std::error_code missing;
  if (const auto size = std::filesystem::file_size(program.folder() / database, missing); missing || size == 0) return;
  const Outcome verified = program.run({"verify", database});
  EXPECT_EQ(verified.exit_code, 0) << verified.output << verified.errors;
}

/// Lets calls fail in a command; `after` looks at what it has left.
void let_fail(FaultyProgram& faulty, const std::string& command, bool allocations,
              const std::function<void(const FaultyOutcome&)>& after) {
  const std::uint64_t count = faulty.count(command, allocations);
  ASSERT_GT(count, 10U) << "the test would show nothing";
  testing::Test::RecordProperty(allocations ? "allocations" : "calls", static_cast<int>(count));
  for (const Fault& fault : faults_to_try(count, allocations, allocations ? kMostAllocations : kMostCalls)) {
    SCOPED_TRACE(command + ", " + text_of(fault));
    const FaultyOutcome outcome = faulty.run(command, fault);
    expect_said(outcome);
    after(outcome);
    if (testing::Test::HasFatalFailure()) return;
  }
}

/// By whether it is allocations that fail.
class Faults : public testing::TestWithParam<bool> {
 protected:
  void SetUp() override {
    if (LACUNA_WATCHED) GTEST_SKIP() << "the sanitizer has its own allocator";
  }
};

TEST_P(Faults, InARunLoseNothingThatWasCommitted) {
  const Program prepared;
  prepared.write("small.toml", kTiny);
  ASSERT_EQ(prepared.run({"run", "small.toml", "--db", "whole.db", "--threads", "1"}).exit_code, 0);
  const std::string hash = prepared.run({"hash", "whole.db"}).output;
  std::filesystem::remove(prepared.folder() / "whole.db");
  FaultyProgram faulty(prepared);
  const Program& program = faulty.program();
  const std::string run = "lacuna run small.toml --threads 1";
  let_fail(faulty, run, GetParam(), [&](const FaultyOutcome&) {
    expect_sound(program, "small.db");
    const bool begun = program.shell("lacuna runs small.db 2>/dev/null | grep -q small").exit_code == 0;
    const Outcome on = program.shell(run + (begun ? " --resume" : ""));
    EXPECT_EQ(on.exit_code, 0) << on.errors;
    EXPECT_EQ(program.run({"hash", "small.db"}).output, hash);
    EXPECT_THAT(faulty.new_names(), testing::ElementsAre("small.db"));
  });
}

TEST_P(Faults, InAnAddLeaveTheOldFileOrTheNewOne) {
  const Program prepared;
  write_pendulum(prepared);
  ASSERT_EQ(prepared.run({"compare", "rig.toml"}).exit_code, 0);
  const std::string before = prepared.read("rig.toml");
  FaultyProgram faulty(prepared);
  const Program& program = faulty.program();
  const std::string add = "lacuna add rig.toml coulomb_friction --where joint.hinge";
  ASSERT_EQ(faulty.run(add, {.at = 0}).exit_code, 0);
  const std::string edited = program.read("rig.toml");
  ASSERT_NE(edited, before);
  let_fail(faulty, add, GetParam(), [&](const FaultyOutcome& outcome) {
    expect_sound(program, "rig.db");
    const std::string now = program.read("rig.toml");
    EXPECT_THAT(now, AnyOf(before, edited));
    if (outcome.exit_code == 0) {
      EXPECT_EQ(now, edited);
    }
    const Outcome again = now == edited ? program.run({"compare", "rig.toml"}) : program.shell(add);
    EXPECT_EQ(again.exit_code, 0) << again.errors;
    EXPECT_EQ(program.read("rig.toml"), edited);
    EXPECT_THAT(faulty.new_names(), IsEmpty());
  });
}

TEST_P(Faults, InABackupLeaveAWholeCopyOrNone) {
  const Program prepared;
  prepared.write("small.toml", kTiny);
  ASSERT_EQ(prepared.run({"run", "small.toml"}).exit_code, 0);
  const std::string hash = prepared.run({"hash", "small.db"}).output;
  FaultyProgram faulty(prepared);
  const Program& program = faulty.program();
  let_fail(faulty, "lacuna backup small.db copy.db", GetParam(), [&](const FaultyOutcome& outcome) {
    const bool there = std::filesystem::exists(program.folder() / "copy.db");
    if (outcome.exit_code == 0) {
      EXPECT_TRUE(there);
    }
    if (there) {
      EXPECT_EQ(program.run({"hash", "copy.db"}).output, hash);
    }
    expect_sound(program, "copy.db");
    EXPECT_EQ(program.run({"hash", "small.db"}).output, hash);
    EXPECT_EQ(program.run({"backup", "small.db", "next.db"}).exit_code, 0);
    std::set<std::string> names = faulty.new_names();
    names.erase("copy.db");
    EXPECT_THAT(names, testing::ElementsAre("next.db"));
  });
}

TEST_P(Faults, InAMergeTakeRunsInWholeOrNotAtAll) {
  const Program prepared;
  prepared.write("small.toml", kTiny);
  for (const char* shard : {"a.db", "b.db"})
    ASSERT_EQ(prepared.run({"run", "small.toml", "--db", shard, "--seed", shard[0] == 'a' ? "1" : "2"}).exit_code, 0);
  FaultyProgram faulty(prepared);
  const Program& program = faulty.program();
  const std::string merge = "lacuna merge all.db a.db b.db";
  let_fail(faulty, merge, GetParam(), [&](const FaultyOutcome& outcome) {
    expect_sound(program, "all.db");
    for (const char* shard : {"a.db", "b.db"}) expect_sound(program, shard);
    if (outcome.exit_code != 0) {
      EXPECT_EQ(program.shell(merge).exit_code, 0);
    }
    EXPECT_THAT(program.run({"sql", "all.db", "--csv", "SELECT count(*) AS n FROM run"}).output, "n\n2\n");
    EXPECT_THAT(faulty.new_names(), testing::ElementsAre("all.db"));
  });
}

INSTANTIATE_TEST_SUITE_P(Of, Faults, testing::Values(false, true),
                         [](const auto& of) { return of.param ? "allocations" : "calls"; });

}  // namespace
}  // namespace lacuna
