#include "end_to_end/printed_lines.h"
#include "end_to_end/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace lacuna {
namespace {

using testing::HasSubstr;

constexpr const char* kLine = "triangle motor 0.3 N*m 0.5 Hz 4 s";

/// A pendulum that hides a friction which no model has.
class PredictCommand : public testing::Test {
 protected:
  PredictCommand() {
    program_.copy_first_steps();  // which has the robot
    program_.copy_smoke();
  }
  Outcome run(int passes = 3, const std::vector<std::string>& more = {}) const {
    return with({"run", "smoke/simulated-pendulum.toml", "--set", "experiment.passes=" + std::to_string(passes),
                 "--set", "test.duration=\"2 s\"", "--set", "estimation.ensemble=4"},
                more);
  }
  Outcome predict(const std::string& test, const std::vector<std::string>& more = {}) const {
    return with({"predict", "smoke/simulated-pendulum.toml", "--test", test}, more);
  }
  void expect_bad(const Outcome& outcome, const std::string& sentence) const {
    EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
    EXPECT_THAT(outcome.errors, HasSubstr(sentence));
  }
  const Program program_;

 private:
  Outcome with(std::vector<std::string> words, const std::vector<std::string>& more) const {
    words.insert(words.end(), more.begin(), more.end());
    return program_.run(words);
  }
};

TEST_F(PredictCommand, TellsABandThatTrialsNewToTheModelsSupport) {
  expect_bad(predict(kLine), "no such database");
  ASSERT_EQ(run().exit_code, 0);
  const Outcome told = predict(kLine, {"--csv=band.csv", "--out", "band.svg", "--json=band.json"});
  ASSERT_EQ(told.exit_code, 0) << told.errors;
  EXPECT_THAT(told.output, HasSubstr("run 1, pass 3 · 2 models · triangle motor"));
  EXPECT_THAT(told.output, HasSubstr("2 models of the run, which err more than twice as much as the best"));
  EXPECT_THAT(told.output, HasSubstr("3 trials that were new to the models at the time"));
  EXPECT_THAT(told.output, HasSubstr("→ lacuna trial smoke/simulated-pendulum.toml --test 'triangle"));
  EXPECT_THAT(program_.read("band.svg"), HasSubstr("95 % band"));
  const std::vector<std::string> lines = lines_of(program_.read("band.csv"));
  EXPECT_EQ(lines.front(), "t [s],angle mean [rad],angle lower [rad],angle upper [rad]");
  EXPECT_EQ(lines.size(), 2002U) << "a row each 2 ms of 4 s, and the header";
  const nlohmann::json json = nlohmann::json::parse(program_.read("band.json"));
  const nlohmann::json& channel = json["channels"][0];
  EXPECT_GE(channel["held_out"]["widening"].get<double>(), channel["held_out"]["factor"].get<double>())
      << "what is told holds 95 % of the readings";
  EXPECT_EQ(predict(kLine, {"--threads", "1"}).output, predict(kLine, {"--threads", "2"}).output);
  EXPECT_EQ(predict(kLine, {"--set", "experiment.passes=3"}).output, predict(kLine).output) << "as the run was begun";
  program_.shell("echo '# later' >> smoke/simulated-pendulum.toml");
  EXPECT_THAT(predict(kLine).errors, HasSubstr("differs from what run 1 was begun with"));
}

TEST_F(PredictCommand, TakesTestsOfTheRunAndFilesOfCommands) {
  ASSERT_EQ(run().exit_code, 0);
  const Outcome tests =
      program_.run({"sql", "simulated-pendulum.db", "--csv", "SELECT test FROM transfer_gap WHERE for_transfer"});
  const std::string number = lines_of(tests.output).back();
  const Outcome numbered = predict("test " + number);
  ASSERT_EQ(numbered.exit_code, 0) << numbered.errors;
  EXPECT_THAT(numbered.output, HasSubstr("carried out as trial 3, new to the models"));
  EXPECT_THAT(predict("0").output, HasSubstr("carried out as trial 0, to which the models were fitted"));
  expect_bad(predict("test 1000000"), "run 1 has no such test");

  program_.write("commands.csv", "t [s],motor [N*m]\n0,0.1\n1,-0.1\n2,0\n");
  const Outcome file = predict("commands.csv", {"--csv"});
  ASSERT_EQ(file.exit_code, 0) << file.errors;
  EXPECT_EQ(lines_of(file.output).size(), 1002U);
  EXPECT_EQ(lines_of(predict("commands.csv", {"--csv", "--duration", "1 s"}).output).size(), 502U);
}

TEST_F(PredictCommand, AsksTheNewestRunOrTheOneThatIsNamed) {
  ASSERT_EQ(run(1, {"--replicates", "2"}).exit_code, 0);
  const Outcome newest = predict(kLine);
  EXPECT_THAT(newest.output, HasSubstr("run 2, pass 1"));
  EXPECT_THAT(newest.output, HasSubstr("uncalibrated: 1 trial was new to the models at the time"));
  EXPECT_THAT(newest.output, HasSubstr("--set experiment.passes=4"));
  EXPECT_THAT(predict(kLine, {"--run", "1"}).output, HasSubstr("run 1, pass 1"));
  expect_bad(predict(kLine, {"--run", "3"}), "has no run 3");
  expect_bad(predict(kLine, {"--set", "experiment.name='other'", "--db", "simulated-pendulum.db"}),
             "has no run of other with a pass that has ended");
}

TEST_F(PredictCommand, PredictsInTheSetupThatIsAskedFor) {
  program_.write_loads();
  ASSERT_EQ(program_.run({"run", "loads.toml", "--quiet"}).exit_code, 0);
  const auto of = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"predict", "loads.toml", "--test", kLine};
    words.insert(words.end(), more.begin(), more.end());
    return program_.run(words);
  };
  const Outcome first = of({}), heavy = of({"--setup", "steps", "--json=heavy.json"});
  ASSERT_EQ(heavy.exit_code, 0) << heavy.errors;
  EXPECT_THAT(first.output, HasSubstr("setup sine (body.arm.mass = 0.53 kg), that of the first recording"));
  EXPECT_THAT(heavy.output, HasSubstr("setup steps (body.arm.mass = 0.56 kg)\n"));
  EXPECT_THAT(heavy.output, HasSubstr(" --setup steps --csv=commands.csv"));
  EXPECT_EQ(nlohmann::json::parse(program_.read("heavy.json"))["setup"]["set"]["body.arm.mass"]["value"], 0.56);
  EXPECT_NE(of({"--csv"}).output, of({"--csv", "--setup", "steps"}).output) << "another load moves in another way";
  expect_bad(of({"--setup", "heavy"}), "there is no setup \"heavy\"");
  expect_bad(of({"--setup", "none"}), "there is no setup \"none\"");
}

TEST_F(PredictCommand, RefusesWhatItCannotPredict) {
  ASSERT_EQ(run(1).exit_code, 0);
  expect_bad(predict("triangle engine 0.3 N*m 0.5 Hz 4 s"), "no actuator \"engine\"");
  expect_bad(predict("missing.csv"), "missing.csv");
  expect_bad(predict(kLine, {"--duration", "soon"}), "--duration");
  expect_bad(predict("0", {"--duration", "soon"}), "--duration");
  expect_bad(predict(kLine, {"--json", "--csv"}), "cannot both go to standard output");
  expect_bad(predict(kLine, {"--json=band", "--csv=./band"}), "is named by two options");
  const Outcome set = predict(kLine, {"--set", "test.duration=1", "--set", "model.free={}"});
  expect_bad(set, "--set test.duration=1: the models and trials of a run are those");
  expect_bad(set, "--set model.free={}");
  constexpr const char* kForget =
      "python3 -c 'import sqlite3; c = sqlite3.connect(\"simulated-pendulum.db\"); "
      "c.executescript(\"DELETE FROM ensemble_value; DELETE FROM ensemble_model\")'";
  ASSERT_EQ(program_.shell(kForget).exit_code, 0) << "a database as an older version left it";
  expect_bad(predict(kLine), "did not keep the models of its passes");
}

}  // namespace
}  // namespace lacuna
