#include "end_to_end/program.h"
#include "end_to_end/small_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace lacuna {
namespace {

using testing::HasSubstr;

constexpr int kStopped = 75;

std::string asked(const Program& program, const std::string& database, const std::string& sql) {
  return program.run({"sql", database, "--csv", sql}).output;
}

TEST(TimeLimitOfDiagnose, EndsWithAPreliminaryVerdictAndTheNextCallFindsTheWholeOne) {
  const Program program;
  program.copy_first_steps();
  const std::vector<std::string> command = {"diagnose", "first-steps.toml", "--among", "coulomb_friction"};
  std::vector<std::string> limited = command;
  limited.insert(limited.end(), {"--time-limit", "1 ms", "--json=found.json"});
  const Outcome stopped = program.run(limited);
  EXPECT_EQ(stopped.exit_code, kStopped) << stopped.errors;
  EXPECT_THAT(stopped.output, HasSubstr("verdict cannot_tell · preliminary\n"));
  EXPECT_THAT(stopped.output,
              HasSubstr("The search was stopped by --time-limit '1 ms', during: the fit of the model."));
  EXPECT_THAT(stopped.output, HasSubstr("Not examined: coulomb_friction @ joint.hinge."));
  EXPECT_THAT(stopped.errors,
              HasSubstr("stopped by --time-limit '1 ms'. Run the command again with a longer --time-limit"));
  const nlohmann::json document = nlohmann::json::parse(program.read("found.json"));
  EXPECT_EQ(document["stopped"]["during"], "the fit of the model");
  EXPECT_TRUE(document["probability"].is_null());
  EXPECT_THAT(asked(program, "first-steps.db", "SELECT verdict, probability IS NULL FROM diagnoses"),
              HasSubstr("\ncannot_tell,1"));
  EXPECT_THAT(asked(program, "first-steps.db", "SELECT ending FROM run"), HasSubstr("\ninterrupted"));

  const Outcome whole = program.run(command);
  EXPECT_EQ(whole.exit_code, 0) << whole.errors;
  EXPECT_THAT(whole.output, HasSubstr("verdict effect_found"));
  EXPECT_EQ(whole.output.find("(from the database)"), std::string::npos);
}

TEST(TimeLimitOfAdd, LeavesTheFileAsItIs) {
  const Program program;
  program.copy_first_steps();
  const std::string text = program.read("first-steps.toml");
  const Outcome stopped =
      program.run({"add", "first-steps.toml", "coulomb_friction", "--where", "joint.hinge", "--time-limit", "0.001"});
  EXPECT_EQ(stopped.exit_code, kStopped) << stopped.errors;
  EXPECT_THAT(stopped.errors, HasSubstr("stopped by --time-limit 0.001 s"));
  EXPECT_THAT(stopped.errors, HasSubstr("first-steps.toml is unchanged"));
  EXPECT_EQ(program.read("first-steps.toml"), text);
}

TEST(TimeLimitOfRun, EndsAfterAGenerationAndIsResumed) {
  const Program program;
  program.write("small.toml", kSmallRun);
  const Outcome stopped = program.run({"run", "small.toml", "--threads", "1", "--time-limit", "10 ms"});
  EXPECT_EQ(stopped.exit_code, kStopped) << stopped.errors;
  EXPECT_THAT(stopped.errors,
              HasSubstr("stopped by --time-limit '10 ms'; lacuna run small.toml --threads 1 --time-limit "
                        "'10 ms' --resume continues from here"));
  const Outcome resumed = program.run({"run", "small.toml", "--threads", "1", "--resume"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.errors;
}

TEST(TimeLimitOfFit, ThatIsLongEnoughChangesNothing) {
  const Program program;
  program.copy_first_steps();
  const Outcome fitted = program.run({"fit", "first-steps.toml", "--time-limit", "1 h"});
  EXPECT_EQ(fitted.exit_code, 0) << fitted.errors;
  EXPECT_THAT(asked(program, "first-steps.db", "SELECT ending FROM run"), HasSubstr("\ndone"));
}

TEST(TimeLimit, ThatIsNoneIsRefusedWithWhatToWrite) {
  const Program program;
  program.copy_first_steps();
  for (const char* command : {"fit", "compare", "diagnose", "run"}) {
    const Outcome outcome = program.run({command, "first-steps.toml", "--time-limit", "5 minutes"});
    EXPECT_EQ(outcome.exit_code, 2) << command;
    EXPECT_THAT(outcome.errors,
                HasSubstr("--time-limit '5 minutes': is not a duration; write seconds, or a number with "
                          "its unit: --time-limit 300, --time-limit '5 min'"));
  }
  const Outcome zero = program.run({"fit", "first-steps.toml", "--time-limit", "0"});
  EXPECT_EQ(zero.exit_code, 2);
  EXPECT_THAT(zero.errors, HasSubstr("--time-limit 0: must be longer than 0"));
}

}  // namespace
}  // namespace lacuna
