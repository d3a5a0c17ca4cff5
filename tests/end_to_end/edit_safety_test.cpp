#include "end_to_end/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

namespace lacuna {
namespace {

using testing::HasSubstr;

const std::vector<std::string> kAddFriction = {"add", "first-steps.toml", "coulomb_friction", "--where", "joint.hinge"};

/// Whether `add` has entered the model with the effect into its database, and fits it now. Asked by another
/// process: what the watched one prints is its own.
bool refits(const Program& program) {
  if (!std::filesystem::exists(program.folder() / "first-steps.db")) return false;
  static const Program observer;
  const Outcome count = observer.run(
      {"sql", (program.folder() / "first-steps.db").string(), "--csv", "SELECT count(*) AS revisions FROM revision"});
  return count.output == "revisions\n2\n";
}

TEST(Add, InterruptedInItsRefitLeavesTheFileAsItWas) {
  const Program program;
  program.copy_first_steps();
  const std::string as_written = program.read("first-steps.toml");
  const Outcome outcome = program.run_and_signal(
      kAddFriction, [&] { return refits(program); }, SIGINT);
  EXPECT_EQ(outcome.exit_code, 75) << outcome.output;
  EXPECT_THAT(outcome.errors, HasSubstr("first-steps.toml is as it was"));
  EXPECT_EQ(program.read("first-steps.toml"), as_written);
  EXPECT_THAT(program.run({"history", "first-steps.toml"}).output,
              testing::ContainsRegex("2 +coulomb_friction +- +- +- +not fitted"));
}

TEST(Add, KilledInItsRefitLeavesTheFileAsItWasAndWorksTheNextTime) {
  const Program program;
  program.copy_first_steps();
  const std::string as_written = program.read("first-steps.toml");
  program.run_and_signal(
      kAddFriction, [&] { return refits(program); }, SIGKILL);
  EXPECT_EQ(program.read("first-steps.toml"), as_written);
  const Outcome again = program.run(kAddFriction);
  EXPECT_EQ(again.exit_code, 0) << again.errors;
  EXPECT_THAT(program.read("first-steps.toml"), HasSubstr("coulomb_friction"));
}

TEST(Add, LeavesAFileAloneThatItsUserChangedDuringTheRefit) {
  const Program program;
  program.copy_first_steps();
  const std::string mine = program.read("first-steps.toml") + "# a thought\n";
  // Signal 0 sends nothing: it only tells when the refit has begun.
  const Outcome outcome = program.run_and_signal(
      kAddFriction,
      [&] {
        if (!refits(program)) return false;
        program.write("first-steps.toml", mine);
        return true;
      },
      0);
  EXPECT_EQ(outcome.exit_code, 1) << outcome.output;
  EXPECT_THAT(outcome.errors, HasSubstr("first-steps.toml: was changed by someone else meanwhile"));
  EXPECT_EQ(program.read("first-steps.toml"), mine);
}

}  // namespace
}  // namespace lacuna
