#include "end_to_end/guide.h"
#include "end_to_end/printed_lines.h"
#include "end_to_end/program.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// The rig of tests/process/rig.py, which is no pendulum: what is found out of it is of no interest here.
constexpr const char* kRigFile = R"([experiment]
name = "rig"
passes = 2
[target]
kind = "process"
command = ["python3", "rig.py", "none"]
trial_limit = "20 s"
pause = 0.0
[model]
file = "robots/servo-pendulum.toml"
set = { "actuator.motor.force_limit" = 0.6 }
free = { "joint.hinge.damping" = [0.0, 0.2] }
[engine]
step = "10 ms"
[test]
encoding = "command_series"
duration = "1 s"
parameters = { lowest_frequency = 1.0 }
[estimation]
parameters = { population = 4, keep = 2, generations = 1 }
[exploration]
fitness = "model_disagreement"
fitness_parameters = { noise = 0.001 }
parameters = { population = 4, keep = 2, generations = 1 }
[fit]
method = "free_run"
starts = 1
)";
constexpr const char* kSteps = "steps motor 0.3 N*m 2 Hz 1 s seed 7";

class OutsideRig : public testing::Test {
 protected:
  OutsideRig() {
    program_.copy_first_steps();
    program_.write("rig.toml", kRigFile);
    program_.write("rig.py", source_file("tests/process/rig.py"));
  }
  static std::string fault(const std::string& name) {
    return R"(target.command=["python3", "rig.py", ")" + name + "\"]";
  }
  Outcome lacuna(std::vector<std::string> words, const std::string& rig = "none") const {
    words.insert(words.begin() + 1, "rig.toml");
    words.insert(words.end(), {"--set", fault(rig)});
    return program_.run(words);
  }
  std::string sql(const std::string& query, const std::string& database = "rig.db") const {
    const Outcome outcome = program_.run({"sql", database, "--csv", query});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    const std::vector<std::string> lines = lines_of(outcome.output);
    return lines.empty() ? "" : lines.back();
  }
  std::string hash(const std::string& database) const {
    const std::string line = program_.run({"hash", database}).output;
    return line.substr(0, line.find(' '));
  }
  bool is_there(const std::string& file) const { return std::filesystem::exists(program_.folder() / file); }
  bool rig_has_ended() const {
    const pid_t rig = std::stoi(program_.read("pid"));
    for (int i = 0; i < 1000; ++i) {
      const std::string status = "/proc/" + std::to_string(rig) + "/stat";
      std::ifstream file(status);
      const std::string text(std::istreambuf_iterator<char>(file), {});
      if (text.empty() || text.find(") Z ") != std::string::npos)
        return true;  // nobody waits for orphans in some places
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }
  const Program program_;
};

TEST_F(OutsideRig, IsAskedWhatItIsByCheck) {
  const Outcome good = lacuna({"check"});
  ASSERT_EQ(good.exit_code, 0) << good.errors;
  EXPECT_THAT(
      good.output,
      HasSubstr("process \"test rig\": accepts whole command series (series) and one command per reading (exchange); "
                "sensor heat; sensor angle in deg; actuator motor, -600 to 600 mN·m"));
  const Outcome wrong = lacuna({"check"}, "wrong names");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.errors, AllOf(HasSubstr("the sensor \"angle\", which the target does not have"),
                                  HasSubstr("the actuator \"brake\"")));
  const Outcome controllers = program_.run({"check", "rig.toml", "--set", fault("only series"), "--set",
                                            "test.encoding=\"recurrent_network\"", "--set", "test.parameters={}"});
  EXPECT_EQ(controllers.exit_code, 2);
  EXPECT_THAT(controllers.errors, HasSubstr("takes only whole command series"));
  EXPECT_FALSE(is_there("rig.db"));
}

TEST_F(OutsideRig, HasItsSettingsChecked) {
  const Outcome bad = program_.run({"check", "rig.toml", "--set", "target.folder=\"nowhere\"", "--set",
                                    "target.robot=\"quadruped\"", "--set", "target.start_limit=0"});
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_THAT(bad.errors, AllOf(HasSubstr("\"nowhere\" is not a folder"),
                                HasSubstr("is only used with kind = \"simulated\""), HasSubstr("start_limit")));
  const Outcome missing = program_.run({"check", "rig.toml", "--set", "target.command=[\"no-such-program\"]"});
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.errors, HasSubstr("no-such-program cannot be started: No such file"));
}

TEST_F(OutsideRig, CarriesOutTrialsThatFitAndCompareTake) {
  ASSERT_EQ(lacuna({"trial", "--test", kSteps}).exit_code, 0);
  ASSERT_EQ(lacuna({"trial", "--test", kSteps, "--holdout"}).exit_code, 0);
  ASSERT_EQ(program_.run({"trial", "rig.toml", "--test", kSteps, "--set", "target.version=\"2\""}).exit_code, 0);
  const Outcome compare = lacuna({"compare"});
  ASSERT_EQ(compare.exit_code, 0) << compare.errors;
  EXPECT_THAT(compare.output, HasSubstr("1 fit trial, 1 held-out trial")) << "the third is of another version";
  EXPECT_EQ(sql("SELECT count(*) FROM carried_out"), "3");
}

TEST_F(OutsideRig, OfAnotherVersionIsAnotherTarget) {
  ASSERT_EQ(lacuna({"run"}).exit_code, 0);
  ASSERT_EQ(lacuna({"trial", "--test", kSteps}).exit_code, 0);
  const Outcome moved = program_.run({"fit", "rig.toml", "--set", "target.environment={ PORT = \"/dev/ttyUSB1\" }"});
  ASSERT_EQ(moved.exit_code, 0) << moved.errors;
  EXPECT_THAT(moved.output, HasSubstr("3 fit trials")) << "two of the run, and the single one";
  EXPECT_THAT(moved.errors, testing::Not(HasSubstr("left out")));
  const std::string repaired = "target.version=\"2\"";
  ASSERT_EQ(program_.run({"trial", "rig.toml", "--test", kSteps, "--set", repaired}).exit_code, 0);
  const Outcome fit = program_.run({"fit", "rig.toml", "--set", repaired});
  ASSERT_EQ(fit.exit_code, 0) << fit.errors;
  EXPECT_THAT(fit.output, HasSubstr("1 fit trial"));
  EXPECT_THAT(fit.errors, HasSubstr("4 trials in rig.db are from another target.version and left out"));
  EXPECT_THAT(program_.run({"check", "rig.toml", "--set", repaired}).output, HasSubstr("4 trials in rig.db"));
}

TEST_F(OutsideRig, TrialsCarriedOutAtOnceAreBothKept) {
  const std::string trial = std::string("lacuna trial rig.toml --test '") + kSteps + "' --set '" +
                            fault("meets another") + "' --set target.trial_limit=60";
  const Outcome both = program_.shell(trial + " & " + trial + "; first=$?; wait $! && exit $first");
  EXPECT_EQ(both.exit_code, 0) << both.errors;
  EXPECT_EQ(sql("SELECT count(DISTINCT name) FROM trial JOIN carried_out ON trial.id = carried_out.trial"), "2");
}

TEST_F(OutsideRig, ThatFailsInATrialLosesNothing) {
  for (const auto& [rig, sentence] : std::initializer_list<std::pair<const char*, const char*>>{
           {"dies", "ended with exit code 3; its last lines on standard error:\n  motor driver: over-current"},
           {"nan", "sent NaN or Infinity"},
           {"too few", "too few samples"},
           {"prints", "sent a line that is not a JSON object"},
           {"crashes in hello", "no rig at /dev/ttyUSB0"},
           {"refuses", "says: the arm is not at rest"}}) {
    const Outcome failed = lacuna({"trial", "--test", kSteps}, rig);
    EXPECT_EQ(failed.exit_code, 1) << rig;
    EXPECT_THAT(failed.errors, HasSubstr(sentence));
  }
  const Outcome slow = program_.run(
      {"trial", "rig.toml", "--test", kSteps, "--set", fault("hangs"), "--set", "target.trial_limit=\"0.3 s\""});
  EXPECT_EQ(slow.exit_code, 1);
  EXPECT_THAT(slow.errors, HasSubstr("did not answer in time (the limit is target.trial_limit, 0.3 s beyond"));
  EXPECT_THAT(slow.errors, HasSubstr("trial-1 is stored as failed"));
  EXPECT_EQ(sql("SELECT count(*) FROM failed_trials WHERE trial = 'trial-1'"), "7");
  EXPECT_EQ(sql("SELECT group_concat(DISTINCT ending) FROM runs"), "failed");
  const Outcome again = lacuna({"trial", "--test", kSteps});
  ASSERT_EQ(again.exit_code, 0) << again.errors;
  EXPECT_THAT(again.output, HasSubstr("trial-1"));
}

TEST_F(OutsideRig, RepeatsATestThatFailedToTheSameRows) {
  ASSERT_EQ(lacuna({"run", "--db", "whole.db"}).exit_code, 0);
  const Outcome repeated = lacuna({"run"}, "dies once");
  ASSERT_EQ(repeated.exit_code, 0) << repeated.errors;
  EXPECT_THAT(repeated.errors, AllOf(HasSubstr("trial 0 failed: "), HasSubstr("over-current")));
  EXPECT_EQ(sql("SELECT trial || ' ' || count(*) FROM failed_trials"), "0 1");
  EXPECT_EQ(hash("rig.db"), hash("whole.db"));
  const Outcome fit = lacuna({"fit"}, "dies once");
  EXPECT_EQ(fit.exit_code, 0) << fit.errors;
  EXPECT_THAT(fit.output, HasSubstr("2 fit trials"));
}

TEST_F(OutsideRig, ThatFailsAgainAndAgainEndsARunThatCanBeResumed) {
  ASSERT_EQ(lacuna({"run", "--db", "whole.db"}).exit_code, 0);
  const Outcome failed =
      program_.run({"run", "rig.toml", "--set", fault("waits for repair"), "--set", "target.repeats=2"});
  EXPECT_EQ(failed.exit_code, 1);
  EXPECT_THAT(failed.errors,
              AllOf(HasSubstr("trial 0 failed with 5 tests, each tried 3 times; the last error: "),
                    HasSubstr("test 0 is given up; random test 1 takes its place"),
                    HasSubstr("nothing is lost; correct the cause, then "), HasSubstr("--resume continues from here")));
  EXPECT_EQ(sql("SELECT count(*) FROM failed_trials"), "15");
  const Outcome other = program_.run({"run", "rig.toml", "--resume", "--set", "target.version=\"2\""});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.errors, HasSubstr("run 1 was begun with --set"));
  const Outcome resumed =
      program_.run({"run", "rig.toml", "--resume", "--set", fault("none"), "--set", "target.trial_limit=\"30 s\""});
  ASSERT_EQ(resumed.exit_code, 0) << resumed.errors;
  EXPECT_EQ(hash("rig.db"), hash("whole.db"));
}

TEST_F(OutsideRig, EndsWithAnInterruptedRunThatIsResumedToTheSameRows) {
  ASSERT_EQ(lacuna({"run", "--db", "whole.db"}).exit_code, 0);
  const Outcome interrupted =
      program_.run_and_signal({"run", "rig.toml", "--set", fault("hangs once")}, "hangs", SIGINT);
  EXPECT_EQ(interrupted.exit_code, 75) << interrupted.errors;
  EXPECT_THAT(interrupted.errors, HasSubstr("--resume"));
  EXPECT_TRUE(rig_has_ended());
  EXPECT_EQ(sql("SELECT count(*) FROM failed_trials"), "0") << "nothing failed";
  const Outcome resumed = lacuna({"run", "--resume"}, "hangs once");
  ASSERT_EQ(resumed.exit_code, 0) << resumed.errors;
  EXPECT_EQ(hash("rig.db"), hash("whole.db"));
}

TEST_F(OutsideRig, ThatKeepsItsOwnTimeIsResumedToTheSameRows) {
  const Outcome interrupted =
      program_.run_and_signal({"run", "rig.toml", "--set", fault("wavers, then hangs")}, "hangs", SIGINT);
  EXPECT_EQ(interrupted.exit_code, 75) << interrupted.errors;
  ASSERT_EQ(lacuna({"run", "--resume"}, "wavers").exit_code, 0);
  ASSERT_EQ(lacuna({"run", "--db", "whole.db"}, "wavers").exit_code, 0);
  EXPECT_EQ(hash("rig.db"), hash("whole.db"));
  const Outcome again = program_.run({"reproduce", "whole.db", "--trust"});
  EXPECT_EQ(again.exit_code, 0) << again.errors;
}

/// Whoever made a database can have written any program into it.
TEST_F(OutsideRig, ThatADatabaseNamesIsStartedOnlyWhereTheUserTrustsIt) {
  ASSERT_EQ(lacuna({"run"}).exit_code, 0);
  std::filesystem::remove(program_.folder() / "pid");
  const Outcome asked = program_.run({"reproduce", "rig.db"});
  EXPECT_EQ(asked.exit_code, 2);
  EXPECT_THAT(asked.errors, AllOf(HasSubstr("python3 rig.py none"), HasSubstr("was not started"),
                                  HasSubstr("lacuna reproduce rig.db --trust")));
  EXPECT_FALSE(is_there("pid")) << "it ran";
  for (const char* command : {"replay rig.db", "report rig.db --out report.html", "plot rig.db", "runs rig.db"}) {
    program_.shell(std::string("lacuna ") + command);
    EXPECT_FALSE(is_there("pid")) << command;
  }
  const Outcome trusted = program_.run({"reproduce", "rig.db", "--trust"});
  EXPECT_EQ(trusted.exit_code, 0) << trusted.errors;
  EXPECT_THAT(trusted.errors, HasSubstr("starting the program that the database names: "));
  EXPECT_TRUE(is_there("pid"));
  EXPECT_EQ(std::count(asked.errors.begin(), asked.errors.end(), '\n'), 1) << "one line: " << asked.errors;
}

TEST_F(OutsideRig, ThatADatabaseNamesIsShownWithEveryCharacter) {
  ASSERT_EQ(lacuna({"run"}).exit_code, 0);
  const Outcome forged = program_.shell(
      "python3 - <<'EOF'\n"
      "import sqlite3, hashlib\n"
      "d = sqlite3.connect('rig.db')\n"
      "text, overrides = d.execute('SELECT text, overrides FROM experiment_text').fetchone()\n"
      "text = text.replace('\"rig.py\"', '\"-c\", \"open(\\\\\"ran\\\\\", \\\\\"w\\\\\")\\\\n# `x` \\\\u001b[2K\"')\n"
      "digest = hashlib.sha256((text + '\\n[]').encode()).hexdigest()\n"
      "d.execute('UPDATE experiment_text SET text = ?, overrides = ?, digest = ?', (text, '[]', digest))\n"
      "d.commit()\n"
      "EOF");
  ASSERT_EQ(forged.exit_code, 0) << forged.errors;
  const Outcome asked = program_.run({"reproduce", "rig.db"});
  EXPECT_EQ(asked.exit_code, 2);
  EXPECT_THAT(asked.errors, HasSubstr(R"(python3 -c $'open("ran", "w")\x0a# `x` \x1b[2K' none)")) << asked.errors;
  EXPECT_FALSE(is_there("ran"));
}

TEST_F(OutsideRig, IsGivenTimeBeforeATestIsTriedAgain) {
  const auto has_died = [this] {
    if (!is_there("died")) return false;
    std::this_thread::sleep_for(std::chrono::seconds(3));  // in which a run without a pause is done
    return true;
  };
  const Outcome outcome = program_.run_and_signal(
      {"run", "rig.toml", "--set", fault("dies once"), "--set", "target.pause=1000"}, has_died, SIGINT);
  EXPECT_EQ(outcome.exit_code, 75) << outcome.errors;
  EXPECT_EQ(sql("SELECT count(*) FROM failed_trials"), "1");
}

TEST_F(OutsideRig, SeesTheEndOfItsInputWhenLacunaIsKilled) {
  const Outcome outcome = program_.run_and_signal(
      {"trial", "rig.toml", "--test", kSteps, "--set", fault("waits for more")}, "waits", SIGKILL);
  EXPECT_EQ(outcome.exit_code, 128 + SIGKILL);
  EXPECT_TRUE(rig_has_ended());
}

TEST_F(OutsideRig, ServesReplicatesOneAfterAnotherToTheSameRows) {
  const Outcome alone = lacuna({"run", "--replicates", "2", "--threads", "2"}, "works alone");
  ASSERT_EQ(alone.exit_code, 0) << alone.errors;
  EXPECT_EQ(sql("SELECT count(*) FROM failed_trials"), "0") << "none began while another was there";
  ASSERT_EQ(
      program_
          .run({"run", "rig.toml", "--replicates", "2", "--threads", "2", "--set", "target.copies=2", "--db", "two.db"})
          .exit_code,
      0);
  EXPECT_EQ(program_.run({"hash", "rig.db"}).output, program_.run({"hash", "two.db"}).output);
}

}  // namespace
}  // namespace lacuna
