#include "end_to_end/program.h"
#include "end_to_end/small_run.h"
#include "support/small_shape.h"

#include <gmock/gmock.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

constexpr int kDone = 0, kFailed = 1, kBadInput = 2, kInterrupted = 75;

/// A folder with small.toml.
class Run : public testing::Test {
 protected:
  Run() { program_.write("small.toml", kSmallRun); }

  /// The hash of the only run of a database.
  std::string hash(const std::string& database) const {
    const Outcome outcome = program_.run({"hash", database});
    EXPECT_EQ(outcome.exit_code, kDone) << outcome.errors;
    return outcome.output.substr(0, outcome.output.find(' '));
  }

  Program program_;
};

TEST_F(Run, TellsEachPassAndLeavesADatabase) {
  const Outcome outcome = program_.run({"run", "small.toml", "--threads", "1"});
  ASSERT_EQ(outcome.exit_code, kDone) << outcome.errors;
  EXPECT_THAT(outcome.errors, ContainsRegex("pass 1 · error 0\\.[0-9]+ · body\\.\\*\\.mass off by"));
  EXPECT_THAT(outcome.output, ContainsRegex("pass +error +body\\.\\*\\.mass off by"));
  EXPECT_THAT(outcome.output, HasSubstr("storage"));
  const Outcome runs = program_.run({"runs", "small.db"});
  EXPECT_THAT(runs.output, ContainsRegex("1 +small +1 +done +2/2"));
  const Outcome errors =
      program_.run({"sql", "small.db", "SELECT pass, error FROM error_by_pass ORDER BY pass", "--csv"});
  EXPECT_EQ(errors.exit_code, kDone) << errors.errors;
  EXPECT_THAT(errors.output, ContainsRegex("1,0\\.[0-9]+"));
}

std::vector<nlohmann::json> lines_of(const std::string& text) {
  std::vector<nlohmann::json> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(nlohmann::json::parse(line));
  return lines;
}

TEST_F(Run, PrintsALineOfJsonAnEvent) {
  const Outcome outcome = program_.run({"run", "small.toml", "--replicates", "2", "--json"});
  ASSERT_EQ(outcome.exit_code, kDone) << outcome.errors;
  const std::vector<nlohmann::json> lines = lines_of(outcome.output);
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(lines.front().at("event"), "begin");
  EXPECT_EQ(lines.front().at("runs").size(), 2U);
  std::map<std::string, int> count;
  for (const nlohmann::json& line : lines)
    if (line.at("event") != "begin" && line.at("replicate") == 2) ++count[line.at("event")];
  EXPECT_EQ(count["trial"], 3) << "two passes, and one for the transfer";
  EXPECT_EQ(count["pass"], 2);
  EXPECT_EQ(count["end"], 1);
  EXPECT_EQ(lines.back().at("ending"), "done");
}

TEST_F(Run, WritesTheSamePassesIntoAFileOfJson) {
  ASSERT_EQ(program_.run({"run", "small.toml", "--json=run.jsonl"}).exit_code, kDone);
  const Outcome stored = program_.run({"sql", "small.db", "SELECT error FROM error_by_pass ORDER BY pass", "--json"});
  const nlohmann::json errors = nlohmann::json::parse(stored.output);
  std::vector<double> told;
  for (const nlohmann::json& line : lines_of(program_.read("run.jsonl")))
    if (line.at("event") == "pass") told.push_back(line.at("error"));
  ASSERT_EQ(told.size(), errors.size());
  for (std::size_t i = 0; i < told.size(); ++i) EXPECT_EQ(told[i], errors[i].at("error").get<double>());
}

TEST_F(Run, ReplayRefusesAModelOrTrialThatIsNotThere) {
  ASSERT_EQ(program_.run({"run", "small.toml"}).exit_code, kDone);
  const Outcome model = program_.run({"replay", "small.db", "--model", "1000000"});
  EXPECT_EQ(model.exit_code, kBadInput);
  EXPECT_THAT(model.errors, HasSubstr("the run has no such model"));
  const Outcome trial = program_.run({"replay", "small.db", "--trial", "9", "--csv"});
  EXPECT_EQ(trial.exit_code, kBadInput);
  EXPECT_THAT(trial.errors, HasSubstr("only on trials 0, 1"));
}

TEST_F(Run, HasTheSameHashWithOneAndTwoThreadsAndWithReplicatesSideBySide) {
  ASSERT_EQ(program_.run({"run", "small.toml", "--threads", "1", "--db", "one.db"}).exit_code, kDone);
  ASSERT_EQ(program_.run({"run", "small.toml", "--threads", "2", "--db", "two.db"}).exit_code, kDone);
  ASSERT_EQ(program_.run({"run", "small.toml", "--threads", "2", "--replicates", "2", "--db", "side.db"}).exit_code,
            kDone);
  EXPECT_EQ(hash("one.db"), hash("two.db"));
  const Outcome both = program_.run({"hash", "side.db"});
  EXPECT_THAT(both.output, HasSubstr(hash("one.db")));
  EXPECT_THAT(both.output, HasSubstr("run 2 small replicate 2"));
}

TEST_F(Run, HasTheSameHashInWorkerProcesses) {
  program_.write("shape.toml", kSmallShape);
  program_.copy_outside_targets();  // with all robots
  program_.shell("cp -r '" LACUNA_SOURCE_DIRECTORY "/experiments/lifting-servo.toml' '" LACUNA_SOURCE_DIRECTORY
                 "/experiments/data' .");
  const std::string few =
      " --set 'estimation.parameters={population=12,keep=6,generations=4}' --set experiment.passes=2";
  const std::string brief = "small.toml --set test.duration=0.3 --set ";
  for (const std::string& experiment :
       {brief + "experiment.passes=2",
        brief + "estimation.replay=true --set 'estimation.profiled=[\"sensor.*.delay\"]' --set estimation.challenge=2",
        brief +
            "'exploration.fitness=\"model_disagreement\"' --set 'exploration.fitness_parameters={refit=1,noise=0.1}'",
        std::string("shape.toml"), "lifting-servo.toml" + few, "outside-pendulum.toml" + few}) {
    program_.shell("rm -f *.db*");
    for (const std::string way : {"--no-isolate", "--isolate"}) {
      const Outcome outcome =
          program_.shell(fmt::format("lacuna run {} --threads 2 {} --db {}.db", experiment, way, way.substr(2)));
      ASSERT_EQ(outcome.exit_code, kDone) << experiment << outcome.errors;
    }
    EXPECT_EQ(hash("isolate.db"), hash("no-isolate.db")) << experiment;
  }
}

TEST_F(Run, InWorkerProcessesGoesOnFromWhereItWasInterrupted) {
  ASSERT_EQ(program_.run({"run", "small.toml", "--no-isolate", "--db", "whole.db"}).exit_code, kDone);
  const Outcome cut = program_.run_and_signal(
      {"run", "small.toml", "--isolate"}, [&] { return program_.carries_out("small.db"); }, SIGTERM);
  EXPECT_EQ(cut.exit_code, kInterrupted) << cut.errors;
  EXPECT_THAT(cut.errors, HasSubstr("--resume continues from here"));
  const Outcome rest = program_.run({"run", "small.toml", "--resume", "--isolate", "--replicates", "1"});
  ASSERT_EQ(rest.exit_code, kDone) << rest.errors;
  EXPECT_EQ(hash("small.db"), hash("whole.db"));
}

TEST_F(Run, IsReproducedAndReplayedFromTheDatabaseAlone) {
  ASSERT_EQ(program_.run({"run", "small.toml"}).exit_code, kDone);
  std::filesystem::remove(program_.folder() / "small.toml");
  const Outcome again = program_.run({"reproduce", "small.db", "--quiet"});
  EXPECT_EQ(again.exit_code, kDone) << again.errors;
  EXPECT_THAT(again.output, HasSubstr("every row is the same"));
  for (const char* model : {"0", "100", "359"}) {
    const Outcome replay = program_.run({"replay", "small.db", "--model", model});
    EXPECT_EQ(replay.exit_code, kDone) << replay.errors;
  }
  const Outcome csv = program_.run({"replay", "small.db", "--csv"});
  EXPECT_THAT(csv.output, HasSubstr("angle_front_left_measured,angle_front_left_predicted"));
}

/// As where a backup is looked at beside the damaged database.
TEST_F(Run, IsReplayedFromTheDatabaseThatIsNamedAlone) {
  ASSERT_EQ(program_.run({"run", "small.toml", "--db", "backup.db"}).exit_code, kDone);
  program_.write("small.db", "no database");
  for (const char* command : {"replay", "reproduce"}) {
    const Outcome again = program_.run({command, "backup.db"});
    EXPECT_EQ(again.exit_code, kDone) << again.errors;
  }
}

TEST_F(Run, ThatWasChangedInTheDatabaseIsNotReproduced) {
  ASSERT_EQ(program_.run({"run", "small.toml"}).exit_code, kDone);
  ASSERT_EQ(program_.shell("sqlite3 small.db 'UPDATE model SET score = score + 1e-9 WHERE id & 1023 = 7'").exit_code,
            kDone);
  const Outcome again = program_.run({"reproduce", "small.db", "--quiet"});
  EXPECT_EQ(again.exit_code, kFailed);
  EXPECT_THAT(again.errors, HasSubstr("not reproduced"));
}

TEST_F(Run, InterruptedGoesOnToTheSameRows) {
  ASSERT_EQ(program_.run({"run", "small.toml", "--db", "whole.db"}).exit_code, kDone);
  for (const int signal : {SIGINT, SIGTERM}) {
    for (const char* file : {"small.db", "small.db-wal", "small.db-shm"})
      std::filesystem::remove(program_.folder() / file);
    const Outcome cut = program_.run_and_signal(
        {"run", "small.toml"}, [&] { return program_.carries_out("small.db"); }, signal);
    EXPECT_EQ(cut.exit_code, kInterrupted) << cut.errors;
    EXPECT_THAT(cut.errors, HasSubstr("--resume continues from here"));
    const Outcome rest = program_.run({"run", "small.toml", "--resume"});
    ASSERT_EQ(rest.exit_code, kDone) << rest.errors;
    EXPECT_EQ(hash("small.db"), hash("whole.db"));
  }
}

TEST_F(Run, ResumeOfAFinishedRunSucceedsAndSaysWhereItIs) {
  ASSERT_EQ(program_.run({"run", "small.toml"}).exit_code, kDone);
  const Outcome again = program_.run({"run", "small.toml", "--resume"});
  EXPECT_EQ(again.exit_code, kDone) << again.errors;
  EXPECT_THAT(again.output, HasSubstr("small is finished: run 1 in small.db is done"));
  const Outcome lines = program_.run({"run", "small.toml", "--resume", "--json"});
  EXPECT_EQ(lines.output, "") << "which has lines of JSON alone";
  EXPECT_THAT(lines.errors, HasSubstr("small is finished: run 1 in small.db is done"));
  program_.write("small.toml", kSmallRun + "[fit]\nstarts = 3\n");
  const Outcome changed = program_.run({"run", "small.toml", "--resume"});
  EXPECT_EQ(changed.exit_code, kBadInput) << "what the file says now has not been run";
  EXPECT_THAT(changed.errors, HasSubstr("run 1 is done, but it was begun with another version of this experiment"));
}

TEST_F(Run, ResumeRefusesAnExperimentThatHasChanged) {
  ASSERT_EQ(program_
                .run_and_signal(
                    {"run", "small.toml"}, [&] { return program_.carries_out("small.db"); }, SIGINT)
                .exit_code,
            kInterrupted);
  program_.write("small.toml", kSmallRun + "[fit]\nstarts = 3\n");
  const Outcome outcome = program_.run({"run", "small.toml", "--resume"});
  EXPECT_EQ(outcome.exit_code, kBadInput);
  EXPECT_THAT(outcome.errors, HasSubstr("another version of this experiment"));
  program_.write("small.toml", kSmallRun + "# a word about it\n");
  EXPECT_EQ(program_.run({"run", "small.toml", "--resume"}).exit_code, kDone);
}

TEST_F(Run, NamesEveryProblemOfItsSections) {
  const Outcome outcome = program_.run({"run", "small.toml", "--set", "estimation.search=truncatoin", "--set",
                                        "exploration.parameters.keep=0", "--set", "test.parameters.hiden=3"});
  EXPECT_EQ(outcome.exit_code, kBadInput);
  EXPECT_THAT(outcome.errors, HasSubstr("did you mean \"truncation\"?"));
  EXPECT_THAT(outcome.errors, HasSubstr("exploration.parameters.keep"));
  EXPECT_THAT(outcome.errors, HasSubstr("did you mean \"hidden\"?"));
}

TEST_F(Run, WithoutAModelThatCanBeScoredKeepsTheReasons) {
  const Outcome outcome = program_.run({"run", "small.toml", "--set", "model.free={\"body.torso.inertia.xy\"=[5,6]}"});
  EXPECT_EQ(outcome.exit_code, kFailed);
  EXPECT_THAT(outcome.errors, AllOf(HasSubstr("can be scored; the last one: trial 0, "),
                                    HasSubstr("; the view invalid_evaluations lists the reasons")));
  EXPECT_THAT(outcome.output, Not(HasSubstr("lacuna plot")));
  const Outcome reasons = program_.run({"sql", "small.db", "SELECT DISTINCT reason FROM invalid_evaluations", "--csv"});
  EXPECT_THAT(reasons.output, HasSubstr("trial 0, "));
}

TEST_F(Run, ASearchThatCannotBeginIsRefusedByCheckAndBeforeARunBegins) {
  const std::map<std::string, std::string> wrong = {{"estimation.parameters={population=10,keep=20}", "keep = 20"},
                                                    {"exploration.parameters.population=10.5", "population"}};
  for (const auto& [key, problem] : wrong)
    for (const char* command : {"check", "run"}) {
      const Outcome outcome = program_.run({command, "small.toml", "--set", key});
      EXPECT_EQ(outcome.exit_code, kBadInput) << key;
      EXPECT_THAT(outcome.errors, HasSubstr(problem));
      EXPECT_THAT(outcome.errors, HasSubstr(key.substr(0, key.find('.')) + ".parameters"));
    }
  EXPECT_FALSE(std::filesystem::exists(program_.folder() / "small.db"));
}

TEST_F(Run, PicturesPoolReplicatesOfOneSettingOnly) {
  ASSERT_EQ(program_.run({"run", "small.toml"}).exit_code, kDone);
  ASSERT_EQ(program_.run({"run", "small.toml"}).exit_code, kDone);
  const Outcome again = program_.run({"plot", "small.db", "--out", "again"});
  EXPECT_THAT(again.errors, HasSubstr("draws run 2 of small"));
  EXPECT_THAT(program_.read("again/error_by_pass.svg"), HasSubstr("small, run 2"));
  ASSERT_EQ(program_.run({"run", "small.toml", "--set", "estimation.seeds=2", "--replicates", "2"}).exit_code, kDone);
  const Outcome replicates = program_.run({"plot", "small.db", "--out", "replicates"});
  EXPECT_THAT(replicates.errors, HasSubstr("draws runs 3, 4 of small"));
  EXPECT_THAT(program_.read("replicates/error_by_pass.svg"), HasSubstr("small, runs 3, 4"));
  ASSERT_EQ(program_.shell("mkdir -p folder/paths.svg").exit_code, kDone);
  const Outcome folder = program_.run({"plot", "small.db", "--out", "folder"});
  EXPECT_EQ(folder.exit_code, kBadInput);
  EXPECT_THAT(folder.errors, HasSubstr("folder/paths.svg: is a folder"));
}

TEST_F(Run, AFullStandardOutputIsAFailure) {
  ASSERT_EQ(program_.run({"run", "small.toml"}).exit_code, kDone);
  for (const char* command : {"runs small.db", "runs small.db --json", "hash small.db", "sql --views", "plugins list",
                              "plot small.db", "--help"}) {
    const Outcome outcome = program_.shell("lacuna " + std::string(command) + " > /dev/full");
    EXPECT_EQ(outcome.exit_code, kFailed) << command;
    EXPECT_THAT(outcome.errors, HasSubstr("standard output")) << command;
  }
}

TEST_F(Run, DrawsItsPictures) {
  ASSERT_EQ(program_.run({"run", "small.toml"}).exit_code, kDone);
  const Outcome outcome = program_.run({"plot", "small.db", "--out", "pictures"});
  ASSERT_EQ(outcome.exit_code, kDone) << outcome.errors;
  for (const char* name : {"error_by_pass", "parameters_mass", "parameters_delay", "transfer", "paths"})
    EXPECT_THAT(program_.read("pictures/" + std::string(name) + ".svg"), HasSubstr("<svg")) << name;
}

/// Models that bring a robot of their own: run, simulated again.
TEST_F(Run, FindsShapes) {
  program_.write("shape.toml", kSmallShape);
  const Outcome run = program_.run({"run", "shape.toml", "--replicates", "2", "--db", "shape.db"});
  ASSERT_EQ(run.exit_code, kDone) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("→ lacuna plot shape.db"));
  const Outcome replay = program_.run({"replay", "shape.db", "--run", "2"});
  EXPECT_EQ(replay.exit_code, kDone) << replay.errors;
  const Outcome reproduced = program_.run({"reproduce", "shape.db", "--run", "1", "--threads", "3"});
  EXPECT_EQ(reproduced.exit_code, kDone) << reproduced.errors;
}

}  // namespace
}  // namespace lacuna
