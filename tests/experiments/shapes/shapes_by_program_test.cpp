#include "end_to_end/program.h"
#include "end_to_end/small_run.h"
#include "support/small_shape.h"

#include <gmock/gmock.h>

/// lacuna-shapes on databases that lacuna run has written.
namespace lacuna {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

constexpr int kDone = 0, kBadInput = 2;

class Shapes : public testing::Test {
 protected:
  Shapes() {
    program_.write("small.toml", kSmallRun);
    program_.write("small_shape.toml", kSmallShape);
  }
  Outcome shapes(const std::string& arguments) const { return program_.shell("lacuna-shapes " + arguments); }

  Program program_;
};

TEST_F(Shapes, HaveTheirHelpInTheReadme) {
  const Outcome help = shapes("--help");
  EXPECT_EQ(help.exit_code, kDone);
  const Outcome readme = program_.shell("cat " LACUNA_SOURCE_DIRECTORY "/experiments/shapes/README.md");
  EXPECT_THAT(readme.output, HasSubstr("$ lacuna-shapes --help\n" + help.output));
}

TEST_F(Shapes, AreDrawn) {
  const Outcome run = program_.run({"run", "small_shape.toml", "--replicates", "2", "--db", "shape.db"});
  ASSERT_EQ(run.exit_code, kDone) << run.errors;
  const Outcome drawn = shapes("shape.db --out pictures");
  ASSERT_EQ(drawn.exit_code, kDone) << drawn.errors;
  EXPECT_THAT(drawn.output, HasSubstr("small_shape     2"));
  for (const char* name : {"shape_errors", "shape_progress", "shape_models"})
    EXPECT_THAT(program_.read("pictures/" + std::string(name) + ".svg"), HasSubstr("<svg")) << name;
  EXPECT_THAT(program_.read("pictures/shape_models.svg"), HasSubstr("target"));
  const Outcome other = shapes("shape.db --experiment small_shap");
  EXPECT_EQ(other.exit_code, kBadInput);
  EXPECT_THAT(other.errors, HasSubstr("did you mean \"small_shape\"?"));
}

TEST_F(Shapes, AreNotThoseOfRunsThatHaveNotEnded) {
  ASSERT_EQ(program_.run({"run", "small_shape.toml", "--replicates", "3", "--db", "shape.db"}).exit_code, kDone);
  const auto end_as = [&](const std::string& ending, const std::string& runs) {
    return program_.shell("sqlite3 shape.db \"UPDATE run SET ending = " + ending + " WHERE number " + runs + "\"");
  };
  ASSERT_EQ(end_as("'interrupted'", "= 2").exit_code, 0);
  ASSERT_EQ(end_as("NULL", "= 3").exit_code, 0);
  const Outcome drawn = shapes("shape.db");
  ASSERT_EQ(drawn.exit_code, kDone) << drawn.errors;
  EXPECT_THAT(drawn.output, ContainsRegex("small_shape +1 "));
  EXPECT_THAT(
      drawn.errors,
      HasSubstr("small_shape: 2 runs left out, not ended; to continue interrupted runs: lacuna run FILE --resume"));
  ASSERT_EQ(end_as("'failed'", "= 1").exit_code, 0);
  const Outcome named = shapes("shape.db --experiment small_shape");
  EXPECT_EQ(named.exit_code, kBadInput);
  EXPECT_THAT(named.errors, HasSubstr("no run of small_shape has ended"));
  EXPECT_THAT(shapes("shape.db").errors, HasSubstr("has no finished run"));
}

TEST_F(Shapes, AreMissedWhereNoRunHasThem) {
  ASSERT_EQ(program_.run({"run", "small.toml"}).exit_code, kDone);
  const Outcome outcome = shapes("small.db");
  EXPECT_EQ(outcome.exit_code, kBadInput);
  EXPECT_THAT(outcome.errors, HasSubstr("estimation.objective = \"part_distance\""));
}

TEST_F(Shapes, PassOverRunsWithoutUnlessTheyAreAskedFor) {
  ASSERT_EQ(program_.run({"run", "small.toml", "--db", "both.db"}).exit_code, kDone);
  ASSERT_EQ(program_.run({"run", "small_shape.toml", "--db", "both.db"}).exit_code, kDone);
  const Outcome all = shapes("both.db");
  EXPECT_EQ(all.exit_code, kDone) << all.errors;
  EXPECT_THAT(all.output, ContainsRegex("small_shape +1 "));
  EXPECT_THAT(all.output, Not(ContainsRegex("small +1 ")));
  const Outcome named = shapes("both.db --experiment small");
  EXPECT_EQ(named.exit_code, kBadInput);
  EXPECT_THAT(named.errors, HasSubstr("the runs of small have no distance of parts"));
}

}  // namespace
}  // namespace lacuna
