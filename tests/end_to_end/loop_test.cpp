#include "end_to_end/printed_lines.h"
#include "end_to_end/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace lacuna {
namespace {

using testing::HasSubstr;

/// The row of `history --json` of a revision's angle.
nlohmann::json revision(const Program& program, int number) {
  const Outcome history = program.run({"history", "servo-pendulum.toml", "--json"});
  EXPECT_EQ(history.exit_code, 0) << history.errors;
  const nlohmann::json printed = nlohmann::json::parse(history.output);
  for (const nlohmann::json& row : printed["revisions"])
    if (row["revision"] == number && row["channel"] == "angle") return row;
  ADD_FAILURE() << "history knows no revision " << number << ":\n" << history.output;
  return {};
}

/// The bench's truth is in experiments/data/servo_pendulum/bench.h.
constexpr double kManyTimesTheFloor = 8.0;
constexpr double kAtTheFloor = 1.2;
constexpr double kTrueFriction = 0.024;  // N·m
constexpr double kFrictionTolerance = 0.05;

/// As the database has it.
double fitted_friction(const Program& program) {
  const Outcome sql = program.run({"sql", "servo-pendulum.db", "--csv",
                                   "SELECT value FROM fitted_parameters WHERE address LIKE 'effect.%.torque'"});
  EXPECT_EQ(sql.exit_code, 0) << sql.errors;
  const std::vector<std::string> lines = lines_of(sql.output);
  return lines.size() == 2 ? std::stod(lines.back()) : std::nan("");
}

TEST(Loop, TheErrorFallsToTheFloorWhenTheMissingFrictionIsAddedAndUndoRestoresFileAndError) {
  const Program program;
  program.copy_light_servo_pendulum();
  const std::string as_written = program.read("servo-pendulum.toml");

  const Outcome compare = program.run({"compare", "servo-pendulum.toml"});
  ASSERT_EQ(compare.exit_code, 0) << compare.errors;
  const nlohmann::json rigid = revision(program, 1);
  EXPECT_GT(rigid["times_floor"], kManyTimesTheFloor);

  const Outcome add = program.run({"add", "servo-pendulum.toml", "coulomb_friction", "--where", "joint.hinge"});
  ASSERT_EQ(add.exit_code, 0) << add.errors;
  EXPECT_THAT(program.read("servo-pendulum.toml"), HasSubstr("coulomb_friction"));
  EXPECT_NEAR(fitted_friction(program), kTrueFriction, kFrictionTolerance * kTrueFriction);
  ASSERT_EQ(program.run({"compare", "servo-pendulum.toml"}).exit_code, 0);
  const nlohmann::json with_friction = revision(program, 2);
  EXPECT_LT(with_friction["times_floor"], kAtTheFloor) << "held out";
  EXPECT_LT(with_friction["fit_rmse"].get<double>(), kAtTheFloor * with_friction["floor"].get<double>());
  EXPECT_EQ(revision(program, 1)["fit_rmse"], rigid["fit_rmse"]) << "one revision, one error";

  const Outcome undo = program.run({"undo", "servo-pendulum.toml"});
  ASSERT_EQ(undo.exit_code, 0) << undo.errors;
  EXPECT_EQ(program.read("servo-pendulum.toml"), as_written);
  EXPECT_TRUE(revision(program, 1)["current"]);
}

/// A fixed number of the robot file is fitted, and fixed again, as an effect comes and goes.
TEST(Loop, AWrongValueIsFreedAndUndoFixesIt) {
  const Program program;
  program.copy_first_steps();
  std::string text = program.read("first-steps.toml");
  const std::string line = "\"joint.hinge.armature\" = [0.0, 0.02]\n";
  ASSERT_NE(text.find(line), std::string::npos);
  text.erase(text.find(line), line.size());
  program.write("first-steps.toml", text);
  const Outcome add = program.run(
      {"add", "first-steps.toml", "wrong_value", "--where", "joint.hinge.armature", "--start", "armature=0.004"});
  ASSERT_EQ(add.exit_code, 0) << add.errors;
  EXPECT_THAT(program.read("first-steps.toml"),
              HasSubstr("\"joint.hinge.armature\" = { range = [0.0, 0.05], start = 0.004 }\n"));
  EXPECT_THAT(program.run({"history", "first-steps.toml"}).output, HasSubstr("joint.hinge.armature fitted"));
  ASSERT_EQ(program.run({"undo", "first-steps.toml"}).exit_code, 0);
  EXPECT_EQ(program.read("first-steps.toml"), text);

  const Outcome unknown = program.run({"add", "first-steps.toml", "wrong_value", "--where", "joint.hinge.armatur"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.errors, HasSubstr("did you mean \"joint.hinge.armature\"?"));
  const auto refusal = [&](const std::string& where, const std::string& start) {
    const Outcome refused = program.run({"add", "first-steps.toml", "wrong_value", "--where", where, "--start", start});
    EXPECT_EQ(refused.exit_code, 2);
    return refused.errors;
  };
  EXPECT_THAT(refusal("joint.hinge.damping", "damping=0.1"), HasSubstr("joint.hinge.damping is fitted already"));
  EXPECT_THAT(refusal("joint.hinge.armature", "inertia=0.1"), HasSubstr("the value is armature"));
  EXPECT_THAT(refusal("joint.hinge.armature", "armature=9"), HasSubstr("choose a start between 0 and 0.05"));
  EXPECT_EQ(program.read("first-steps.toml"), text);
}

TEST(Loop, AnAddedEffectStartsWhereTheDiagnosisLeftItUnlessAStartIsTyped) {
  const Program program;
  program.copy_first_steps();
  ASSERT_EQ(program.run({"diagnose", "first-steps.toml", "--among", "coulomb_friction"}).exit_code, 0);
  const Outcome add = program.run({"add", "first-steps.toml", "coulomb_friction", "--where", "joint.hinge"});
  ASSERT_EQ(add.exit_code, 0) << add.errors;
  EXPECT_THAT(add.output, HasSubstr("coulomb_friction starts at the values that the diagnosis found"));
  EXPECT_THAT(program.read("first-steps.toml"), HasSubstr("start = { torque = 0.02"));

  ASSERT_EQ(program.run({"undo", "first-steps.toml"}).exit_code, 0);
  const Outcome typed = program.run({"add", "first-steps.toml", "coulomb_friction", "--start", "torque=0.01"});
  ASSERT_EQ(typed.exit_code, 0) << typed.errors;
  EXPECT_THAT(typed.output, HasSubstr("coulomb_friction is placed on joint.hinge, the only possible place\n"));
  EXPECT_THAT(program.read("first-steps.toml"), HasSubstr("where = \"joint.hinge\""));
  EXPECT_THAT(typed.output, testing::Not(HasSubstr("values that the diagnosis found")));
  EXPECT_THAT(program.read("first-steps.toml"), HasSubstr("start = { torque = 0.01 }"));
}

}  // namespace
}  // namespace lacuna
