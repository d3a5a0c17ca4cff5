#include "end_to_end/printed_lines.h"
#include "end_to_end/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sstream>
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

  Outcome with_words(const std::vector<std::string>& words) const { return program_.run(words); }

 private:
  Outcome with(std::vector<std::string> words, const std::vector<std::string>& more) const {
    words.insert(words.end(), more.begin(), more.end());
    return program_.run(words);
  }
};

TEST_F(PredictCommand, TellsABandThatTrialsNewToTheModelsSupport) {
  ASSERT_EQ(run().exit_code, 0);
  const Outcome told = predict(kLine, {"--csv=band.csv", "--out", "band.svg", "--json=band.json"});
  ASSERT_EQ(told.exit_code, 0) << told.errors;
  EXPECT_THAT(told.output, HasSubstr("run 1, pass 3 · 2 models · triangle motor"));
  EXPECT_THAT(told.output, HasSubstr("2 models with more than twice the best model's error"));
  EXPECT_THAT(told.output, HasSubstr("3 trials were predicted before a model was fitted to them"));
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
  EXPECT_THAT(predict(kLine).errors, HasSubstr("has changed since run 1 began"));
}

TEST_F(PredictCommand, TakesTestsOfTheRunAndFilesOfCommands) {
  ASSERT_EQ(run().exit_code, 0);
  const Outcome tests =
      program_.run({"sql", "simulated-pendulum.db", "--csv", "SELECT test FROM transfer_gap WHERE for_transfer"});
  const std::string number = lines_of(tests.output).back();
  const Outcome numbered = predict("test " + number);
  ASSERT_EQ(numbered.exit_code, 0) << numbered.errors;
  EXPECT_THAT(numbered.output, HasSubstr("carried out as trial 3, to which the models were not fitted"));
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
  EXPECT_THAT(newest.output, HasSubstr("uncalibrated: 1 trial was predicted before a model was fitted to it"));
  EXPECT_THAT(newest.output, HasSubstr("--set experiment.passes=4"));
  EXPECT_THAT(predict(kLine, {"--run", "1"}).output, HasSubstr("run 1, pass 1"));
  expect_bad(predict(kLine, {"--run", "3"}), "has no run 3");
  EXPECT_THAT(predict(kLine, {"--set", "experiment.name='other'", "--db", "simulated-pendulum.db"}).output,
              HasSubstr("other · revision 1 · model with its values as written"))
      << "the runs are of another experiment";
  expect_bad(predict(kLine, {"--run", "1", "--fitted"}), "give only one of them");
  expect_bad(with_words({"predict", "smoke/simulated-pendulum.toml"}), "say which test");
  EXPECT_THAT(predict(kLine, {"--fitted"}).output, HasSubstr("fitted model, 1 free value")) << "to the run's trials";
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
  EXPECT_THAT(first.output, HasSubstr("setup sine (body.arm.mass = 0.53 kg) (the first recording's)"));
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
  expect_bad(set, "--set test.duration=1: the run's models and trials belong to the settings");
  expect_bad(set, "--set model.free={}");
  constexpr const char* kForget =
      "python3 -c 'import sqlite3; c = sqlite3.connect(\"simulated-pendulum.db\"); "
      "c.executescript(\"DELETE FROM ensemble_value; DELETE FROM ensemble_model\")'";
  ASSERT_EQ(program_.shell(kForget).exit_code, 0) << "a database as an older version left it";
  expect_bad(predict(kLine), "was made by an older version");
}

/// Cells of the rows that begin with `name`, or of all; numbers alone.
std::vector<std::vector<double>> rows_of(const std::string& csv, const std::string& name = "") {
  std::vector<std::vector<double>> rows;
  for (const std::string& line : lines_of(csv)) {
    if (!line.starts_with(name) || (name.empty() && line.starts_with("time"))) continue;
    std::vector<double>& cells = rows.emplace_back();
    std::istringstream words(line.substr(name.empty() ? 0 : name.size() + 1));
    for (std::string cell; std::getline(words, cell, ',');) cells.push_back(std::stod(cell));
  }
  return rows;
}

TEST_F(PredictCommand, SimulatesTheFittedModelOnTheFitTrialsWhereThereIsNoRun) {
  const Outcome told =
      program_.run({"predict", "first-steps.toml", "--csv=model.csv", "--json=model.json", "--out", "model.svg"});
  ASSERT_EQ(told.exit_code, 0) << told.errors;
  EXPECT_THAT(told.output, HasSubstr("first-steps · revision 1 · fitted model, 3 free values · 2 fit trials"));
  EXPECT_THAT(told.output, HasSubstr("A single model has no spread"));
  EXPECT_THAT(told.output, HasSubstr("1 held-out trial is left out"));
  EXPECT_THAT(program_.run({"sql", "first-steps.db", "--csv", "SELECT count(*) FROM holdout_looks"}).output,
              HasSubstr("\n0"))
      << "nothing was looked at";
  EXPECT_THAT(lines_of(program_.read("model.csv")).front(),
              testing::StrEq("trial,t [s],angle predicted [rad],angle measured [rad]"));
  EXPECT_THAT(program_.read("model.svg"), HasSubstr("steps.csv: angle [rad]"));
  EXPECT_THAT(program_.read("model.csv"), testing::Not(HasSubstr("chirp.csv")));
  const nlohmann::json json = nlohmann::json::parse(program_.read("model.json"));
  EXPECT_EQ(json["models"], 1);
  EXPECT_EQ(json["predictions"].size(), 2U);

  ASSERT_EQ(program_.run({"compare", "first-steps.toml", "--out", "compared", "--quiet"}).exit_code, 0);
  const auto compared = rows_of(program_.read("compared/sine.csv-predictions.csv")),
             predicted = rows_of(program_.read("model.csv"), "sine.csv");
  ASSERT_EQ(compared.size(), predicted.size());
  constexpr double kPrinted = 1e-8;  // nine digits
  for (std::size_t i = 0; i < compared.size(); ++i) {
    EXPECT_EQ(compared[i][0], predicted[i][0]) << "s";
    EXPECT_NEAR(compared[i][2], predicted[i][1], kPrinted) << "predicted at " << compared[i][0] << " s";
    EXPECT_NEAR(compared[i][1], predicted[i][2], kPrinted) << "measured";
  }
}

TEST_F(PredictCommand, SimulatesOneModelOnATestThatIsGiven) {
  program_.write("rest.csv", "t [s],motor [N*m]\n0,0\n2,0\n");
  const Outcome told = predict("rest.csv", {"--csv=rest-model.csv"});
  ASSERT_EQ(told.exit_code, 0) << told.errors;
  EXPECT_THAT(told.output, HasSubstr("simulated-pendulum · revision 1 · model with its values as written · rest.csv"));
  const std::vector<std::string> lines = lines_of(program_.read("rest-model.csv"));
  EXPECT_EQ(lines.front(), "test,t [s],angle predicted [rad]");
  EXPECT_EQ(lines.size(), 1002U) << "a row each 2 ms of 2 s, and the header";
  for (const std::vector<double>& row : rows_of(program_.read("rest-model.csv"), "rest.csv"))
    EXPECT_NEAR(row[1], 0.0, 1e-12) << "it hangs at rest, and no torque acts";

  const Outcome fitted = program_.run({"predict", "first-steps.toml", "--test", kLine, "--out", "line.svg"});
  ASSERT_EQ(fitted.exit_code, 0) << fitted.errors;
  EXPECT_THAT(fitted.output, HasSubstr("fitted model, 3 free values · triangle motor"));
  EXPECT_THAT(program_.read("line.svg"), HasSubstr("triangle motor 0.3 N*m 0.5 Hz 4 s"));
  const Outcome one = program_.run({"predict", "first-steps.toml", "--test", "steps.csv"});
  EXPECT_THAT(one.output, HasSubstr("steps.csv"));
  EXPECT_THAT(one.output, testing::Not(HasSubstr("sine.csv")));
}

TEST_F(PredictCommand, SaysWhatOneModelCannotPredict) {
  const auto of = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"predict"};
    words.insert(words.end(), more.begin(), more.end());
    return program_.run(words);
  };
  expect_bad(of({"smoke/simulated-pendulum.toml"}), "has no fit trial to simulate. Say which test: --test");
  expect_bad(of({"first-steps.toml", "--test", "chirp.csv"}), "this trial is held out");
  expect_bad(of({"first-steps.toml", "--test", "sine.csv", "--duration", "1 s"}), "has a setup and a duration already");
  expect_bad(of({"first-steps.toml", "--test", "17"}), "a number names a test of a run");
  expect_bad(of({"first-steps.toml", "--test", "triangle engine 0.3 N*m 0.5 Hz 4 s"}), "no actuator \"engine\"");
}

}  // namespace
}  // namespace lacuna
