#include "end_to_end/program.h"
#include "end_to_end/small_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

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
  EXPECT_THAT(changed.output, HasSubstr("run 1, table fitted_value: changed since the run ended: different content\n"));
  EXPECT_THAT(changed.errors, HasSubstr("first-steps.db: differs from what was stored; keep the file, and restore a "
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
  EXPECT_THAT(changed.output, HasSubstr("view runs differs from the one that this program makes\n"));
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

/// Of a run that was killed nothing is sealed: what speaks for it are its checkpoint, and what follows from it.
TEST(Verify, FindsWhatAResumeWouldFind) {
  const Program program;
  program.write("small.toml", kSmallRun);
  const std::vector<std::string> begin = {"run", "small.toml", "--threads", "1"};
  const auto ready = [&] {
    return !program.shell("sqlite3 -readonly small.db 'SELECT 1 FROM model LIMIT 1' 2>/dev/null").output.empty();
  };
  ASSERT_EQ(program.run_and_signal(begin, ready, SIGKILL).exit_code, 128 + SIGKILL);
  ASSERT_EQ(program.run({"backup", "small.db", "killed.db"}).exit_code, 0);
  const std::string empty = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";  // SHA-256 of nothing
  for (const std::string& damage :
       {std::string("UPDATE checkpoint SET state = zeroblob(length(state))"),
        "UPDATE checkpoint SET state = x'', digest = '" + empty + "'",
        std::string("UPDATE trial_condition SET sensor_noise = '[0.125]'"),
        std::string("UPDATE trial_condition SET initial = 'nothing'"),
        std::string("DELETE FROM model_score WHERE model = (SELECT max(id) FROM model);"
                    "DELETE FROM model WHERE id = (SELECT max(id) FROM model)"),
        std::string("DELETE FROM test_score; DELETE FROM test"), std::string("DELETE FROM target_trial")}) {
    ASSERT_EQ(program
                  .shell("cp killed.db damaged.db && sqlite3 damaged.db \"PRAGMA ignore_check_constraints = 1; " +
                         damage + "\"")
                  .exit_code,
              0);
    const Outcome verified = program.run({"verify", "damaged.db"});
    EXPECT_EQ(verified.exit_code, 1) << damage;
    EXPECT_THAT(verified.output, HasSubstr("run 1: ")) << damage;
    EXPECT_EQ(program.run({"run", "small.toml", "--resume", "--db", "damaged.db"}).exit_code, 1) << damage;
  }
  EXPECT_EQ(program.run({"verify", "killed.db"}).exit_code, 0);
  EXPECT_EQ(program.run({"run", "small.toml", "--resume", "--db", "killed.db"}).exit_code, 0);
}

}  // namespace
}  // namespace lacuna
