#include "end_to_end/resume_fixture.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

/// Runs that were interrupted go on to the same rows, each with its own settings.
namespace lacuna {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

TEST_F(Resume, EachRunGoesOnWithItsOwnSeed) {
  interrupt({});
  interrupt({"--seed", "2"});
  const Outcome outcome = program_.run({"run", "small.toml", "--resume"});
  ASSERT_EQ(outcome.exit_code, kDone) << outcome.errors;
  ASSERT_EQ(program_.run({"run", "small.toml", "--db", "one.db"}).exit_code, kDone);
  ASSERT_EQ(program_.run({"run", "small.toml", "--db", "two.db", "--seed", "2"}).exit_code, kDone);
  EXPECT_EQ(hash("small.db", 1), hash("one.db"));
  EXPECT_EQ(hash("small.db", 2), hash("two.db"));
}

TEST_F(Resume, GoesOnWithTheRunsOfTheSameSettingsAndLeavesTheOthers) {
  interrupt({});
  interrupt({"--set", "target.hidden_seed=3"});
  const Outcome plain = program_.run({"run", "small.toml", "--resume"});
  ASSERT_EQ(plain.exit_code, kDone) << plain.errors;
  EXPECT_THAT(plain.errors, HasSubstr("run 2 was begun with --set target.hidden_seed=3"));
  EXPECT_THAT(program_.run({"runs", "small.db"}).output,
              AllOf(ContainsRegex("1 +small +1 +done"), ContainsRegex("2 +small +1 +interrupted")));
  const Outcome finished = program_.run({"run", "small.toml", "--resume"});
  EXPECT_EQ(finished.exit_code, kDone) << finished.errors;
  EXPECT_THAT(finished.errors, HasSubstr("run 2 was begun with --set target.hidden_seed=3"));
  EXPECT_THAT(finished.output, HasSubstr("small is finished: run 1 in small.db is done"));
  const Outcome none = program_.run({"run", "small.toml", "--set", "target.hidden_seed=4", "--resume"});
  EXPECT_EQ(none.exit_code, kBadInput);
  EXPECT_THAT(none.errors, AllOf(HasSubstr("run 1 is done, but it was begun with no --set"),
                                 HasSubstr("run 2 was begun with --set target.hidden_seed=3"),
                                 HasSubstr("has no run of small to continue")));
  EXPECT_EQ(program_.run({"run", "small.toml", "--set", "target.hidden_seed=3", "--resume"}).exit_code, kDone);
}

TEST_F(Resume, AFailedRunOfOtherSettingsIsNoObstacle) {
  interrupt({"--set", "target.hidden_seed=3"});
  ASSERT_EQ(program_.shell("sqlite3 small.db \"UPDATE run SET ending = 'failed'\"").exit_code, 0);
  interrupt({});
  EXPECT_EQ(program_.run({"run", "small.toml", "--resume"}).exit_code, kDone);
}

TEST_F(Resume, RefusesASeedThatIsNotTheRuns) {
  interrupt({});
  const Outcome outcome = program_.run({"run", "small.toml", "--seed", "5", "--resume"});
  EXPECT_EQ(outcome.exit_code, kBadInput);
  EXPECT_THAT(outcome.errors, HasSubstr("run 1 was begun with --seed 1"));
}

/// One line for a supervisor, the first time and every other.
TEST_F(Resume, BeginsWhereThereIsNothingToGoOnWith) {
  const Outcome first = program_.run({"run", "small.toml", "--resume"});
  ASSERT_EQ(first.exit_code, kDone) << first.errors;
  EXPECT_THAT(first.errors, HasSubstr("small.db has no run of small yet, so a new one begins\n"));
  ASSERT_EQ(program_.run({"run", "small.toml", "--db", "whole.db"}).exit_code, kDone);
  EXPECT_EQ(hash("small.db"), hash("whole.db"));
  const Outcome other =
      program_.run({"run", "small.toml", "--set", "experiment.name=other", "--db", "small.db", "--resume"});
  ASSERT_EQ(other.exit_code, kDone) << other.errors;
  EXPECT_THAT(other.errors, HasSubstr("small.db has no run of other yet"));
  const Outcome done = program_.run({"run", "small.toml", "--resume"});
  EXPECT_EQ(done.exit_code, kDone) << done.errors;
  EXPECT_THAT(done.output, HasSubstr("small is finished: run 1 in small.db is done"));
  EXPECT_THAT(program_.run({"runs", "small.db"}).output, Not(HasSubstr("\n3 "))) << "no second run of what is done";
}

TEST_F(Resume, LeavesARunThatAnotherProcessCarriesOut) {
  Outcome second;
  const std::vector<std::string> first = {"run", "small.toml", "--set", "experiment.passes=8"};
  const Outcome outcome = program_.run_and_signal(
      first,
      [&] {
        if (!program_.carries_out("small.db")) return false;
        second = program_.shell("lacuna run small.toml --set experiment.passes=8 --resume 2>&1");
        return second.output.find("another process") != std::string::npos;
      },
      SIGINT);
  EXPECT_EQ(second.exit_code, kBadInput);
  EXPECT_THAT(second.output, HasSubstr("another process is carrying out run 1"));
  EXPECT_EQ(outcome.exit_code, kInterrupted) << "the first goes on undisturbed: " << outcome.errors;
}

/// It holds the socket of its run until it has ended.
TEST_F(Resume, WaitsForAKilledProcessToEnd) {
  interrupt({});
  program_.write("ending.py",
                 "import os, socket, time\n"
                 "file = os.stat('small.db')\n"
                 "held = socket.socket(socket.AF_UNIX)\n"
                 "held.bind(f'\\0lacuna run {file.st_dev} {file.st_ino} 1')\n"
                 "open('held', 'w').close()\n"
                 "time.sleep(0.5)\n");
  const Outcome outcome =
      program_.shell("python3 ending.py & until [ -e held ]; do sleep 0.01; done; lacuna run small.toml --resume");
  EXPECT_EQ(outcome.exit_code, kDone) << outcome.errors;
}

TEST_F(Resume, WaitsForASignOfLifeFromAnotherMachine) {
  interrupt({});
  const std::string foreign =
      "sqlite3 small.db \"INSERT INTO claim VALUES (1, 'elsewhere', 'elsewhere 17', $(stat -c %i "
      "small.db), 0)\"; ";
  const Outcome alive = program_.shell(
      foreign + "(sleep 8; sqlite3 small.db 'UPDATE claim SET beat = 1') & lacuna run small.toml --resume");
  EXPECT_EQ(alive.exit_code, kBadInput);
  EXPECT_THAT(alive.errors, AllOf(HasSubstr("began to carry out a run; waiting 15 s"),
                                  HasSubstr("another process is carrying out run 1")));
  const Outcome gone = program_.run({"run", "small.toml", "--resume"});
  EXPECT_EQ(gone.exit_code, kDone) << gone.errors;
}

/// Some of these torsos have an inertia that no body has.
TEST_F(Resume, WithInvalidModelsEndsWithTheSameRowsAndReasons) {
  const std::vector<std::string> free = {"--set",
                                         "model.free={\"body.torso.mass\"=[1,7],\"body.torso.inertia.xy\"=[-1,1]}",
                                         "--set", "estimation.parameters={population=300,keep=150,generations=30}"};
  std::vector<std::string> whole = {"run", "small.toml", "--db", "whole.db"};
  whole.insert(whole.end(), free.begin(), free.end());
  ASSERT_EQ(program_.run(whole).exit_code, kDone);
  interrupt(free, true);
  EXPECT_THAT(ask("small.db", "SELECT count(*) > 0 FROM invalid_evaluations"), HasSubstr("1"));
  std::vector<std::string> rest = {"run", "small.toml", "--resume"};
  rest.insert(rest.end(), free.begin(), free.end());
  ASSERT_EQ(program_.run(rest).exit_code, kDone);
  EXPECT_EQ(hash("small.db"), hash("whole.db"));
  const char* const reasons = "SELECT number, reason FROM invalid_evaluations ORDER BY kind, number";
  EXPECT_EQ(ask("small.db", reasons), ask("whole.db", reasons));
}

constexpr const char* kArm = R"([experiment]
name = "small"
passes = 2
[target]
kind = "simulated"
file = "arm.toml"
hidden = { "body.arm.mass" = { uniform = [0.3, 1.0] } }
[model]
file = "arm.toml"
free = { "body.arm.mass" = [0.3, 1.0] }
[test]
duration = 1.0
[estimation]
parameters = { population = 40, keep = 20, generations = 30 }
[exploration]
parameters = { population = 10, keep = 5, generations = 5 }
)";

constexpr const char* kArmRobot = R"([robot]
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
[actuator.motor]
joint = "hinge"
kind = "force"
command_lower = -0.5
command_upper = 0.5
[sensor.angle]
joint = "hinge"
kind = "joint_position"
)";

TEST_F(Resume, RefusesARobotFileThatHasChanged) {
  program_.write("small.toml", kArm);
  program_.write("arm.toml", kArmRobot);
  interrupt({});
  program_.write("arm.toml", std::string(kArmRobot) + "# another\n");
  const Outcome changed = program_.run({"run", "small.toml", "--resume"});
  EXPECT_EQ(changed.exit_code, kBadInput);
  EXPECT_THAT(changed.errors, HasSubstr("run 1 was begun with another version of arm.toml"));
  program_.write("arm.toml", kArmRobot);
  ASSERT_EQ(program_.run({"run", "small.toml", "--resume"}).exit_code, kDone);

  program_.write("arm.toml", std::string(kArmRobot) + "# another\n");
  EXPECT_THAT(program_.run({"reproduce", "small.db", "--quiet"}).errors, HasSubstr("another version of arm.toml"));
  EXPECT_THAT(program_.run({"replay", "small.db"}).errors, HasSubstr("another version of arm.toml"));
}

TEST_F(Resume, ReproducedElsewhereSaysWhichFolderIsMeant) {
  program_.write("small.toml", kArm);
  program_.write("arm.toml", kArmRobot);
  ASSERT_EQ(program_.run({"run", "small.toml"}).exit_code, kDone);
  const Outcome outcome = program_.shell("mkdir elsewhere && cd elsewhere && lacuna reproduce ../small.db");
  EXPECT_EQ(outcome.exit_code, kBadInput);
  EXPECT_THAT(outcome.errors, AllOf(HasSubstr("small.toml: is not in this folder"), HasSubstr("elsewhere")));
}

TEST_F(Resume, CountsTheSecondsOfAllItsProcesses) {
  interrupt({}, true);
  const double before = std::stod(ask("small.db", "SELECT seconds FROM eea_runs").substr(8));
  ASSERT_EQ(program_.run({"run", "small.toml", "--resume", "--json=lines"}).exit_code, kDone);
  const std::string lines = program_.read("lines");
  EXPECT_NE(lines.find("\"begin\""), lines.rfind("\"begin\"")) << "behind those of the first process";
  const auto member = [&](const std::string& name) {
    const std::string key = "\"" + name + "\":";
    return std::stod(lines.substr(lines.rfind(key) + key.size()));
  };
  EXPECT_NEAR(member("seconds"), before + member("process_seconds"), 0.05);
}

TEST_F(Resume, TheCommandItNamesCanBeTypedAgain) {
  const std::string quoted = "lacuna run small.toml --set 'model.free={\"body.*.mass\"=[1,7]}'";
  const Outcome outcome = program_.run_and_signal(
      {"run", "small.toml", "--set", "model.free={\"body.*.mass\"=[1,7]}"},
      [&] { return program_.carries_out("small.db"); }, SIGINT);
  EXPECT_EQ(outcome.exit_code, kInterrupted);
  EXPECT_THAT(outcome.errors, HasSubstr(quoted + " --resume continues from here"));
  EXPECT_EQ(program_.shell(quoted + " --resume").exit_code, kDone);
}

}  // namespace
}  // namespace lacuna
