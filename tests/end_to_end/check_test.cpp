#include "end_to_end/program.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace lacuna {
namespace {

using testing::HasSubstr, testing::Not;

/// Whatever is wrong with a recording is said by `check`, before anything is fitted.
class Check : public testing::Test {
 protected:
  void SetUp() override { program_.copy_first_steps(); }

  /// Replaces the line `number` (from 1) of a recording.
  void replace_line(const std::string& file, int number, const std::string& line) const {
    std::string text = program_.read(file);
    std::size_t begin = 0;
    for (int i = 1; i < number; ++i) begin = text.find('\n', begin) + 1;
    text.replace(begin, text.find('\n', begin) - begin, line);
    program_.write(file, text);
  }
  Outcome check(const std::vector<std::string>& options = {}) const {
    std::vector<std::string> words = {"check", "first-steps.toml"};
    words.insert(words.end(), options.begin(), options.end());
    return program_.run(words);
  }
  const std::string sine_ = "data/servo_pendulum/sine.csv", chirp_ = "data/servo_pendulum/chirp.csv";
  Program program_;
};

TEST_F(Check, SaysWhatWasRead) {
  const Outcome outcome = check();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("chirp.csv (held out): 2001 samples, 4.00 s, 500 Hz\n"));
  EXPECT_THAT(outcome.output, HasSubstr("total 6003 samples, 12.0 s\n"));
  EXPECT_THAT(outcome.output, HasSubstr("angle, measured: column angle_deg in deg, -"));
  EXPECT_THAT(outcome.output, HasSubstr("motor, commanded: column torque_Nm in N·m, -"));
}

TEST_F(Check, GivesWhatWasReadAsJson) {
  const Outcome outcome = check({"--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const nlohmann::json json = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(json["database"], "first-steps.db");
  EXPECT_EQ(json["robot"]["joints"], nlohmann::json({"hinge"}));
  EXPECT_EQ(json["free"][0]["address"], "body.arm.mass");
  EXPECT_EQ(json["trials"][2],
            nlohmann::json({{"trial", "chirp.csv"}, {"held_out", true}, {"samples", 2001}, {"duration_s", 4.0}}));
  EXPECT_EQ(json["channels"][0]["column_unit"], "deg");
  EXPECT_EQ(json["channels"][0]["unit"], "rad");
  EXPECT_GT(json["channels"][0]["largest"].get<double>(), json["channels"][0]["smallest"].get<double>());
  EXPECT_EQ(check({"--json=read.json"}).exit_code, 0);
  EXPECT_EQ(nlohmann::json::parse(program_.read("read.json")), json);
}

TEST_F(Check, GivesProblemsAsLinesOfJsonToAProgramThatAsks) {
  replace_line(sine_, 4, "0.004,zero,0.0");
  const Outcome outcome = program_.shell("LACUNA_MESSAGES=json lacuna check first-steps.toml --quite");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(nlohmann::json::parse(outcome.errors)["problem"]["message"].get<std::string>(), HasSubstr("--quite"));
  const Outcome read = program_.shell("LACUNA_MESSAGES=json lacuna check first-steps.toml");
  EXPECT_EQ(read.exit_code, 2);
  const nlohmann::json problem = nlohmann::json::parse(read.errors)["problem"];
  EXPECT_THAT(problem["file"].get<std::string>(), testing::EndsWith("sine.csv"));
  EXPECT_EQ(problem["line"], 4);
  EXPECT_THAT(program_.shell("LACUNA_MESSAGES=yaml lacuna check first-steps.toml").errors,
              HasSubstr("LACUNA_MESSAGES: \"yaml\" is not a message format; set it to json or text"));
}

TEST_F(Check, NamesEveryBadPlaceOfEveryRecordingAtOnce) {
  replace_line(sine_, 4, "0.004,zero,0.0");
  replace_line(chirp_, 5, "0.001,0.0,0.0");
  const Outcome outcome = check();
  EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
  EXPECT_THAT(outcome.errors, HasSubstr("sine.csv:4: column `torque_Nm` has `zero`"));
  EXPECT_THAT(outcome.errors, HasSubstr("chirp.csv:5: "));
}

TEST_F(Check, RefusesAColumnThatIsNotThereAndAUnitThatDoesNotFit) {
  EXPECT_THAT(check({"--set", "target.sensors.angle.column=\"angle_dge\""}).errors,
              HasSubstr("no column `angle_dge` (did you mean \"angle_deg\"?)"));
  EXPECT_THAT(check({"--set", "target.sensors.angle.unit=\"mm\""}).errors, HasSubstr("has another unit than angle"));
  EXPECT_THAT(check({"--set", "noise.process.\"sensor.angle\"=0.1"}).errors, HasSubstr("sensor.angle"));
}

TEST_F(Check, PrintsNotesOnWhatLooksOdd) {
  const Outcome outcome = check({"--set", "target.commands.motor.unit=\"mN*m\""});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("has the unit N*m in its name but is read in mN*m"));
}

TEST_F(Check, HasItsDoubtsRepeatedByWhatUsesTheRecordings) {
  program_.write(sine_, program_.read(sine_) + "8.002,0.2");
  const Outcome compare = program_.run({"compare", "first-steps.toml"});
  EXPECT_EQ(compare.exit_code, 0) << compare.errors;
  EXPECT_THAT(compare.errors,
              HasSubstr("sine.csv:4003: the file ends in the middle of its last line, which is left out"));
  EXPECT_THAT(compare.errors, Not(HasSubstr("chirp.csv")));
}

TEST_F(Check, TakesATestOfOneControlPeriodWhateverUnitsItIsWrittenIn) {
  const Outcome outcome = program_.run({"check", LACUNA_SOURCE_DIRECTORY "/experiments/topology-range-4.toml", "--set",
                                        "engine.step=\"9 ms\"", "--set", "test.duration=\"0.009 s\""});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
}

TEST_F(Check, RefusesARunThatWouldMeanNothing) {
  const auto refused = [&](const std::string& setting) {
    const Outcome outcome =
        program_.run({"check", LACUNA_SOURCE_DIRECTORY "/experiments/topology-range-4.toml", "--set", setting});
    EXPECT_EQ(outcome.exit_code, 2) << setting;
    return outcome.errors;
  };
  EXPECT_THAT(refused("target.parameters.beacons=3"),
              HasSubstr("\"range_right_arm_4\", which the target does not measure"));
  EXPECT_THAT(refused("test.duration=\"5 ms\""), HasSubstr("is shorter than one control period of 10.0 ms"));
  EXPECT_THAT(refused("target.parameters.arms_in_middle=0.3"), HasSubstr("arms_in_middle must be 0"));
  EXPECT_THAT(refused("model.encoding_parameters.lift=0.4"), HasSubstr("lift must be 0 or 1"));
}

/// A ball that was thrown: its start is read off its first readings, and nothing is amiss.
TEST(FreeBody, IsCompared) {
  const Program program;
  std::string readings = "t,x,z\n";
  for (int i = 0; i <= 100; ++i) {
    const double t = 0.01 * i;
    readings += fmt::format("{:.2f},{:.9f},{:.9f}\n", t, 0.2 + 1.5 * t, 1.0 + 3.0 * t - 0.5 * 9.81 * t * t);
  }
  program.write("throw.csv", readings);
  program.write("ball.toml",
                "[robot]\nname = \"ball\"\n[body.ball]\nmass = 0.1\ninertia = [1e-5, 1e-5, 1e-5]\n"
                "[joint.flight]\nkind = \"free\"\nchild = \"ball\"\n"
                "[sensor.place]\nkind = \"body_position\"\nbody = \"ball\"\n");
  program.write("throw.toml",
                "[experiment]\nname = \"throw\"\n[target]\nkind = \"recorded\"\nfiles = [\"throw.csv\"]\n"
                "holdout = []\n[target.time]\ncolumn = \"t\"\n[target.sensors]\n"
                "\"place.x\" = { column = \"x\", unit = \"m\", noise = 0.001 }\n"
                "\"place.z\" = { column = \"z\", unit = \"m\", noise = 0.001 }\n"
                "[model]\nfile = \"ball.toml\"\n");
  const Outcome outcome = program.run({"compare", "throw.toml"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("place.z"));
}

/// Declares a controller of the motor on the angle, with the measured angle as its reference.
void declare_controller(const Program& program) {
  std::string text = program.read("first-steps.toml");
  text.insert(text.find("[model]"),
              "[target.controllers]\n"
              "motor = { reads = \"angle\", reference = { column = \"angle_deg\", unit = \"deg\" }, "
              "proportional = \"8 N*m/rad\" }\n\n");
  program.write("first-steps.toml", text);
}

/// Where they say it, it has not yet cost a fit or a diagnosis.
TEST_F(Check, AndCompareNameAControllerThatDidNotMakeTheCommands) {
  declare_controller(program_);
  const char* sentence =
      "first-steps.toml:25:9: the controller of motor does not reproduce the recorded commands from the recorded "
      "readings: the RMS difference, over the standard deviation of the commands, is 102 % in sine.csv, 102 % in "
      "steps.csv. Check its gains, their signs and the reference\n";
  const Outcome checked = check();
  EXPECT_EQ(checked.exit_code, 0) << checked.errors;
  EXPECT_THAT(checked.output, HasSubstr(sentence));
  const Outcome compared = program_.run({"compare", "first-steps.toml", "--as-is", "--quiet"});
  EXPECT_EQ(compared.exit_code, 0) << compared.errors;
  EXPECT_THAT(compared.errors, HasSubstr(sentence));
}

}  // namespace
}  // namespace lacuna
