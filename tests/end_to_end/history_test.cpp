#include "end_to_end/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace lacuna {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

/// `lacuna history` reads: it neither fits nor spends a look at held-out files, nor does it make a revision.
TEST(History, OfNothingSaysWhatToTypeAndMakesNoDatabase) {
  const Program program;
  program.copy_light_servo_pendulum();
  const Outcome history = program.run({"history", "servo-pendulum.toml"});
  EXPECT_EQ(history.exit_code, 0) << history.errors;
  EXPECT_THAT(history.output, HasSubstr("nothing is stored yet. Next: lacuna compare servo-pendulum.toml"));
  EXPECT_FALSE(std::filesystem::exists(program.folder() / "servo-pendulum.db"));
  const nlohmann::json document =
      nlohmann::json::parse(program.run({"history", "servo-pendulum.toml", "--json"}).output);
  EXPECT_EQ(document["next"], "lacuna compare servo-pendulum.toml");
  EXPECT_TRUE(document["revisions"].empty());
}

TEST(History, LeavesTheDatabaseAsItIs) {
  const Program program;
  program.copy_light_servo_pendulum();
  ASSERT_EQ(program.run({"compare", "servo-pendulum.toml", "--as-is"}).exit_code, 0);
  const std::string before = program.read("servo-pendulum.db");
  const Outcome not_fitted = program.run({"history", "servo-pendulum.toml"});
  EXPECT_THAT(not_fitted.output, ContainsRegex("1\\* +rigid .*not fitted"));
  EXPECT_THAT(not_fitted.output,
              HasSubstr("held-out trials compared 1 time\nrevision 1 is not compared yet. Next: lacuna compare"));
  const Outcome other = program.run({"history", "servo-pendulum.toml", "--set", "engine.substeps=2"});
  EXPECT_THAT(other.output, HasSubstr("the model in the file is not stored yet. Next: lacuna compare"));
  EXPECT_THAT(other.output, Not(HasSubstr("1*")));
  EXPECT_EQ(program.read("servo-pendulum.db"), before);
}

}  // namespace
}  // namespace lacuna
