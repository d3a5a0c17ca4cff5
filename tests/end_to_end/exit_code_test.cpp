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
  text.replace(text.find("substeps"), 8, "subteps");
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

TEST(ExitCode, IsOneWhereTheDatabaseIsNoDatabase) {
  const Program program;
  program.copy_light_servo_pendulum();
  program.write("servo-pendulum.db", "This was a shopping list and is kept.\n");
  const Outcome outcome = program.run({"compare", "servo-pendulum.toml"});
  EXPECT_EQ(outcome.exit_code, kFailed);
  EXPECT_THAT(outcome.errors, HasSubstr("servo-pendulum.db"));
  EXPECT_EQ(program.read("servo-pendulum.db"), "This was a shopping list and is kept.\n");
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
