#include "end_to_end/program.h"
#include "end_to_end/small_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lacuna {
namespace {

using testing::HasSubstr;

/// Nothing that a command stores is written or changed after the end of its run.
TEST(Verify, FindsAllRunsAsTheCommandsLeftThem) {
  const Program program;
  program.copy_first_steps();
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"compare", "first-steps.toml"},
                                             {"add", "first-steps.toml", "viscous_friction", "--where", "joint.hinge"},
                                             {"compare", "first-steps.toml"},
                                             {"undo", "first-steps.toml"},
                                             {"fit", "first-steps.toml"},
                                             {"history", "first-steps.toml"}}) {
    const Outcome outcome = program.run(arguments);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  }
  program.write("small.toml", kSmallRun);
  ASSERT_EQ(program.run({"run", "small.toml", "--replicates", "2", "--db", "first-steps.db"}).exit_code, 0);

  const Outcome sound = program.run({"verify", "first-steps.db"});
  EXPECT_EQ(sound.exit_code, 0) << sound.output << sound.errors;
  EXPECT_THAT(sound.output, testing::MatchesRegex("first-steps.db: [0-9]+ runs as stored\n"));

  ASSERT_EQ(program.shell("sqlite3 first-steps.db \"UPDATE fitted_value SET value = value + 1e-12\"").exit_code, 0);
  const Outcome changed = program.run({"verify", "first-steps.db"});
  EXPECT_EQ(changed.exit_code, 1);
  EXPECT_THAT(changed.output, HasSubstr("run 1, table fitted_value: not what the run ended with: other content\n"));
  EXPECT_THAT(changed.errors, HasSubstr("first-steps.db: is not what was stored; keep the file, and go back to a "
                                        "backup (lacuna backup makes them)"));
}

TEST(Verify, FindsAViewThatIsNotTheProgramsAnyMore) {
  const Program program;
  const std::string search = "population = 12, keep = 6, generations = 2";
  program.write("small.toml", small_experiment("0.2", search, search));
  ASSERT_EQ(program.run({"run", "small.toml"}).exit_code, 0);
  ASSERT_EQ(program.shell("sqlite3 small.db \"CREATE TABLE notes (text); DROP VIEW runs\"").exit_code, 0);
  const Outcome changed = program.run({"verify", "small.db"});
  EXPECT_EQ(changed.exit_code, 1);
  EXPECT_THAT(changed.output, HasSubstr("view runs is not as this program makes it\n"));
  EXPECT_EQ(changed.output.find("notes"), std::string::npos) << "a table more is the user's";
}

/// What is left of a database that was cut off at its first byte is not sound.
TEST(Verify, RefusesAnEmptyFileAsABackupDoes) {
  const Program program;
  program.write("cut.db", "");
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"verify", "cut.db"}, std::vector<std::string>{"backup", "cut.db", "copy.db"}}) {
    const Outcome refused = program.run(arguments);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("cut.db: is empty"));
  }
  EXPECT_FALSE(std::filesystem::exists(program.folder() / "copy.db"));
}

}  // namespace
}  // namespace lacuna
