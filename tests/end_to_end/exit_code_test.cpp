#include "end_to_end/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr int kDone = 0, kFailed = 1, kBadInput = 2, kInterrupted = 75;

TEST(ExitCode, IsZeroForHelpWhichListsTheCommands) {
  const Outcome help = Program().run({"--help"});
  EXPECT_EQ(help.exit_code, kDone);
  for (const char* command : {"check", "fit", "compare", "add", "undo", "history", "plugins", "sql"})
    EXPECT_THAT(help.output, HasSubstr(std::string("\n  ") + command + " "));
}

TEST(ExitCode, IsZeroForAModelWithoutFreeValues) {
  const Program program;
  program.copy_first_steps();
  const Outcome outcome = program.run({"compare", "first-steps.toml", "--set", "model.free={}"});
  EXPECT_EQ(outcome.exit_code, kDone) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("refitted 0 values"));
}

TEST(ExitCode, IsTwoForAWordThatIsNoCommand) {
  const Outcome outcome = Program().run({"histroy"});
  EXPECT_EQ(outcome.exit_code, kBadInput);
  EXPECT_THAT(outcome.errors, HasSubstr("did you mean \"history\""));
}

TEST(ExitCode, IsTwoForAnExperimentThatDoesNotExist) {
  const Outcome outcome = Program().run({"check", "nowhere.toml"});
  EXPECT_EQ(outcome.exit_code, kBadInput);
  EXPECT_THAT(outcome.errors, HasSubstr("nowhere.toml"));
}

TEST(ExitCode, IsTwoForAMisspeltKeyWhichIsNamedWithItsPlace) {
  const Program program;
  program.copy_light_servo_pendulum();
  std::string text = program.read("servo-pendulum.toml");
  text.replace(text.find("\nstep = "), 1, "\nsubteps = 4\n");
  program.write("servo-pendulum.toml", text);
  const Outcome outcome = program.run({"check", "servo-pendulum.toml"});
  EXPECT_EQ(outcome.exit_code, kBadInput);
  EXPECT_THAT(outcome.errors, testing::ContainsRegex("servo-pendulum.toml:[0-9]+:[0-9]+: .*subteps.*substeps"));
}

TEST(ExitCode, IsTwoForARecordingWithTextInANumber) {
  const Program program;
  program.copy_light_servo_pendulum();
  std::string text = program.read("data/servo_pendulum/steps.csv");
  text.replace(text.find("0.004,"), 6, "four,");
  program.write("data/servo_pendulum/steps.csv", text);
  const Outcome outcome = program.run({"compare", "servo-pendulum.toml"});
  EXPECT_EQ(outcome.exit_code, kBadInput);
  EXPECT_THAT(outcome.errors, HasSubstr("steps.csv:4"));
}

TEST(ExitCode, IsTwoForAnEffectThatNoPluginOffersAndTheFileStaysAsItWas) {
  const Program program;
  program.copy_light_servo_pendulum();
  const std::string as_written = program.read("servo-pendulum.toml");
  const Outcome outcome = program.run({"add", "servo-pendulum.toml", "coulomb_fiction", "--where", "joint.hinge"});
  EXPECT_EQ(outcome.exit_code, kBadInput);
  EXPECT_THAT(outcome.errors, HasSubstr("coulomb_friction"));
  EXPECT_EQ(program.read("servo-pendulum.toml"), as_written);
}

TEST(ExitCode, IsTwoForAnEffectsArgumentThatFitsNothingWhichIsNamedAsItWasTyped) {
  const Program program;
  program.copy_light_servo_pendulum();
  const auto errors = [&](const std::vector<std::string>& arguments) {
    std::vector<std::string> command = {"add", "servo-pendulum.toml"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const Outcome outcome = program.run(command);
    EXPECT_EQ(outcome.exit_code, kBadInput);
    EXPECT_THAT(outcome.errors, testing::Not(HasSubstr("model.effects")));
    return outcome.errors;
  };
  EXPECT_THAT(errors({"coulmb_friction", "--where", "joint.hinge"}),
              testing::StartsWith("add coulmb_friction: there is no effect \"coulmb_friction\" (did you mean"));
  EXPECT_THAT(errors({"coulomb_friction", "--where", "joint.hing"}), testing::StartsWith("add --where joint.hing: "));
  EXPECT_THAT(errors({"coulomb_friction", "--where", "body.arm"}), testing::StartsWith("add --where: "));
  EXPECT_THAT(errors({"coulomb_friction", "--where", "joint.hinge", "--start", "torqe=1"}),
              testing::StartsWith("add --start torqe: "));
  EXPECT_THAT(errors({"coulomb_friction", "--where", "joint.hinge", "--fixed", "torqe"}),
              testing::StartsWith("add --fixed torqe: "));
}

TEST(ExitCode, IsTwoForAnEffectThatThePlaceHasAlreadyUnlessTheSecondIsNamed) {
  const Program program;
  program.copy_first_steps();
  const std::vector<std::string> add = {"add", "first-steps.toml", "coulomb_friction", "--where", "joint.hinge"};
  ASSERT_EQ(program.run(add).exit_code, kDone);
  const std::string once = program.read("first-steps.toml");
  const Outcome again = program.run(add);
  EXPECT_EQ(again.exit_code, kBadInput);
  EXPECT_THAT(again.errors, HasSubstr("coulomb_friction: joint.hinge has this effect already"));
  EXPECT_EQ(program.read("first-steps.toml"), once);
  std::vector<std::string> named = add;
  named.insert(named.end(), {"--id", "seal", "--fixed", "torque"});
  EXPECT_EQ(program.run(named).exit_code, kDone);
}

TEST(ExitCode, IsTwoWhereTheDatabaseIsNoDatabaseOfOurs) {
  const Program program;
  program.copy_light_servo_pendulum();
  program.write("servo-pendulum.db", "This was a shopping list and is kept.\n");
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"compare", "servo-pendulum.toml"},
                                             {"history", "servo-pendulum.toml"},
                                             {"sql", "servo-pendulum.db", "SELECT 1"}}) {
    const Outcome outcome = program.run(command);
    EXPECT_EQ(outcome.exit_code, kBadInput) << command.front();
    EXPECT_THAT(outcome.errors, HasSubstr("servo-pendulum.db: is not a Lacuna database"));
  }
  EXPECT_EQ(program.read("servo-pendulum.db"), "This was a shopping list and is kept.\n");
  EXPECT_EQ(program.run({"sql", "nowhere.db", "SELECT 1"}).exit_code, kBadInput);
  EXPECT_EQ(program.run({"sql", ".", "SELECT 1"}).exit_code, kBadInput);
}

TEST(ExitCode, IsOneWhereAFileMayNotGrowFurther) {
  const Program program;
  program.copy_first_steps();
  const Outcome database = program.shell("ulimit -f 100; lacuna fit first-steps.toml");
  EXPECT_EQ(database.exit_code, kFailed);
  EXPECT_THAT(database.errors, HasSubstr("first-steps.db: cannot grow: the disk or the quota is full, or files may"));
  const Outcome json = program.shell("ulimit -f 8; lacuna plugins list --json=plugins.json");
  EXPECT_EQ(json.exit_code, kFailed);
  EXPECT_THAT(json.errors, HasSubstr("plugins.json: cannot be written completely; check that its folder is writable "
                                     "and the disk not full"));
}

TEST(ExitCode, IsZeroForWhatADatabaseInAReadOnlyFolderHas) {
  const Program program;
  if (program.shell("[ $(id -u) != 0 ] || setpriv --bounding-set=-dac_override true").exit_code != 0)
    GTEST_SKIP() << "root may write anywhere, and may not give that up here";
  program.copy_first_steps();
  ASSERT_EQ(program.shell("mkdir kept && lacuna compare first-steps.toml --db kept/a.db && chmod 555 kept").exit_code,
            kDone);
  const auto read_only = [&](const std::string& arguments) {  // root may write anywhere unless it drops that
    return program.shell("may=; [ $(id -u) = 0 ] && may='setpriv --bounding-set=-dac_override'; $may lacuna " +
                         arguments + " --db kept/a.db");
  };
  const Outcome history = read_only("history first-steps.toml");
  EXPECT_EQ(history.exit_code, kDone) << history.errors;
  EXPECT_THAT(history.output, HasSubstr("first-steps · kept/a.db"));
  EXPECT_EQ(read_only("fit first-steps.toml").exit_code, kDone);
  const Outcome look = read_only("compare first-steps.toml");
  EXPECT_EQ(look.exit_code, kFailed);
  EXPECT_THAT(look.errors,
              HasSubstr("kept/a.db: cannot be written: its folder is read-only; name a database elsewhere"));
  EXPECT_EQ(read_only("diagnose first-steps.toml --among coulomb_friction").exit_code, kFailed);
  program.shell("chmod 755 kept");
}

TEST(ExitCode, Is75AfterCtrlCAndTheNextRunWorks) {
  const Program program;
  program.copy_light_servo_pendulum();
  const Outcome interrupted = program.run_and_signal({"fit", "servo-pendulum.toml"}, "servo-pendulum.db", SIGINT);
  EXPECT_EQ(interrupted.exit_code, kInterrupted) << interrupted.output;
  EXPECT_THAT(interrupted.errors, testing::Not(IsEmpty()));
  const Outcome endings = program.run({"sql", "servo-pendulum.db", "SELECT ending FROM runs"});
  EXPECT_THAT(endings.output, HasSubstr("interrupted"));
  EXPECT_EQ(program.run({"fit", "servo-pendulum.toml"}).exit_code, kDone);
}

}  // namespace
}  // namespace lacuna
