#include "end_to_end/printed_lines.h"
#include "end_to_end/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>

namespace lacuna {
namespace {

using testing::HasSubstr;

/// A pendulum that is simulated and hides nothing but where its damping lies.
constexpr const char* kPendulum = R"([experiment]
name = "bench"
[target]
kind = "simulated"
file = "robots/servo-pendulum.toml"
set = { "actuator.motor.force_limit" = 0.5, "joint.hinge.damping" = 0.035 }
noise = { "sensor.angle" = "0.3 mrad" }
[model]
file = "robots/servo-pendulum.toml"
free = { "joint.hinge.damping" = [0.0, 0.2] }
[engine]
step = "4 ms"
[fit]
method = "free_run"
starts = 1
)";
constexpr double kTrueDamping = 0.035;  // N·m·s/rad
constexpr double kDampingTolerance = 0.01;
constexpr const char* kTest = "multisine motor 0.3 N*m 0.25-2 Hz 4 s seed 3";

class TrialCommand : public testing::Test {
 protected:
  TrialCommand() {
    program_.copy_first_steps();
    program_.write("bench.toml", kPendulum);
  }
  Outcome trial(const std::string& test, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"trial", "bench.toml", "--test", test};
    words.insert(words.end(), more.begin(), more.end());
    return program_.run(words);
  }
  void expect_refused(const std::string& test, const std::string& sentence,
                      const std::vector<std::string>& more = {}) const {
    const Outcome outcome = trial(test, more);
    EXPECT_EQ(outcome.exit_code, 2) << test << outcome.output;
    EXPECT_THAT(outcome.errors, HasSubstr(sentence));
    EXPECT_FALSE(std::filesystem::exists(program_.folder() / "bench.db")) << test;
  }
  const Program program_;
};

TEST_F(TrialCommand, IsAllThatASimulatedTargetNeedsForItsFirstFit) {
  const Outcome without = program_.run({"fit", "bench.toml"});
  EXPECT_EQ(without.exit_code, 1);
  EXPECT_THAT(without.errors, HasSubstr("lacuna trial"));

  const Outcome first = trial(kTest);
  ASSERT_EQ(first.exit_code, 0) << first.errors;
  EXPECT_THAT(first.output, HasSubstr("trial-1"));
  ASSERT_EQ(trial(kTest, {"--holdout"}).exit_code, 0);
  const Outcome third = trial("steps motor 0.3 N*m 1 Hz 4 s seed 7", {"--json"});
  ASSERT_EQ(third.exit_code, 0) << third.errors;
  const nlohmann::json told = nlohmann::json::parse(third.output);
  EXPECT_EQ(told["trial"], "trial-3");
  EXPECT_EQ(told["samples"], 1001);

  const Outcome fit = program_.run({"fit", "bench.toml", "--json"});
  ASSERT_EQ(fit.exit_code, 0) << fit.errors;
  const nlohmann::json fitted = nlohmann::json::parse(fit.output);
  EXPECT_NEAR(fitted["values"][0]["value"].get<double>(), kTrueDamping, kDampingTolerance * kTrueDamping);
  const Outcome compare = program_.run({"compare", "bench.toml"});
  EXPECT_EQ(compare.exit_code, 0) << compare.errors;
  EXPECT_THAT(compare.output, HasSubstr("2 fit trials, 1 held-out trial"));
  const Outcome noise = program_.run({"sql", "bench.db", "--csv", "SELECT count(DISTINCT digest) FROM trial"});
  EXPECT_EQ(lines_of(noise.output).back(), "3") << "the same test again has other noise";
}

TEST_F(TrialCommand, LeavesTrialsOfAnotherTargetOut) {
  ASSERT_EQ(trial(kTest).exit_code, 0);
  ASSERT_EQ(
      trial(kTest, {"--set", "target.hidden_seed=9", "--set", "target.set.\"joint.hinge.damping\"=0.1"}).exit_code, 0);
  const Outcome fit = program_.run({"fit", "bench.toml"});
  EXPECT_THAT(fit.output, HasSubstr("1 fit trial "));
}

TEST_F(TrialCommand, WritesTheCommandsOfALineForARigAndTakesThemBack) {
  const Outcome csv = program_.run({"trial", "first-steps.toml", "--test", kTest, "--csv=next.csv"});
  ASSERT_EQ(csv.exit_code, 0) << csv.errors;
  EXPECT_THAT(csv.output, HasSubstr("target.files in first-steps.toml"));
  const std::vector<std::string> lines = lines_of(program_.read("next.csv"));
  EXPECT_EQ(lines.front(), "t [s],motor [N*m]");
  EXPECT_EQ(lines.size(), 2002U) << "a command each 2 ms, the experiment's step, and the end";
  EXPECT_THAT(lines.back(), testing::StartsWith("4,"));
  EXPECT_FALSE(std::filesystem::exists(program_.folder() / "first-steps.db"));
  const Outcome shown = program_.run({"trial", "first-steps.toml", "--test", kTest});
  EXPECT_EQ(shown.output, program_.read("next.csv"));
  EXPECT_THAT(shown.errors, HasSubstr("target.files"));

  const Outcome carried = trial("next.csv");
  ASSERT_EQ(carried.exit_code, 0) << carried.errors;
  const Outcome shorter = program_.run({"trial", "bench.toml", "--test", "next.csv", "--duration", "1 s", "--csv"});
  EXPECT_EQ(lines_of(shorter.output).size(), 502U) << "header, 500 commands and the end";
  const Outcome samples = program_.run({"sql", "bench.db", "--csv", "SELECT duration FROM trial"});
  EXPECT_EQ(lines_of(samples.output).back(), "4");
}

TEST_F(TrialCommand, RefusesWhatTheRigCannotDo) {
  expect_refused("sinus motor 0.3 N*m 1 Hz 4 s", "unknown shape \"sinus\"");
  expect_refused("steps engine 0.3 N*m 1 Hz 4 s", "no actuator \"engine\"");
  expect_refused("steps motor 0.8 N*m 1 Hz 4 s", "-0.5 to 0.5 N*m");
  expect_refused("steps motor 0.3 rad 1 Hz 4 s", "N*m");
  expect_refused("steps motor 0.3 N*m 1 Hz 0.1 s", "use 1 s or more");
  expect_refused(kTest, "--duration", {"--duration", "soon"});
  expect_refused(kTest, "is shorter than one period", {"--duration", "1 s"});
  expect_refused("missing.csv", "missing.csv");
  program_.write("strong.csv", "t [s],motor [N*m]\n0,0.1\n1,0.9\n");
  expect_refused("strong.csv", "exceed its limits");
}

TEST_F(TrialCommand, SetsTheRigUpAsARecordingSays) {
  program_.write_loads();
  const auto commands = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"trial", "loads.toml", "--test", kTest, "--csv=next.csv"};
    words.insert(words.end(), more.begin(), more.end());
    return program_.run(words);
  };
  EXPECT_THAT(commands({}).output, HasSubstr("setup sine (body.arm.mass = 0.53 kg), the first recording's"));
  const Outcome heavy = commands({"--setup", "steps"});
  EXPECT_THAT(heavy.output, HasSubstr("setup steps (body.arm.mass = 0.56 kg)\n"));
  EXPECT_THAT(heavy.output, HasSubstr("[[target.recording]]\nfile = \"new.csv\"\nset = { \"body.arm.mass\" = "
                                      "\"0.56 kg\" }\n"));
  const Outcome unknown = commands({"--setup", "step"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.errors,
              HasSubstr("there is no setup \"step\" (did you mean \"steps\"?); the recordings have the setups sine "
                        "(body.arm.mass = 0.53 kg); steps (body.arm.mass = 0.56 kg)"));
  expect_refused(
      kTest,
      "only recordings have setups ([[target.recording]] with set or own), and this target has kind = \"simulated\"",
      {"--setup", "steps"});
}

TEST_F(TrialCommand, ItsSetupIsInTheDatabaseWithUnits) {
  program_.write_loads();
  ASSERT_EQ(program_.run({"compare", "loads.toml"}).exit_code, 0);
  const Outcome rows =
      program_.run({"sql", "loads.db", "--csv", "SELECT trial, settings FROM trial_setups ORDER BY 1"});
  EXPECT_EQ(rows.output, "trial,settings\nsine.csv,body.arm.mass = 0.53 kg\nsteps.csv,body.arm.mass = 0.56 kg\n");
}

/// All its parts begin equally deep in the ground, and at this command ODE finds no order in which to solve their
/// contacts.
TEST_F(TrialCommand, GetsPastATieOfContacts) {
  const std::string shape = std::string(LACUNA_SOURCE_DIRECTORY) + "/experiments/topology-range-4.toml";
  const auto steps = [&](const std::string& amplitude) {
    return program_.run({"trial", shape, "--test", "steps motor_front " + amplitude + " 5 Hz 1 s"});
  };
  const Outcome share = steps("50 %");
  EXPECT_EQ(share.exit_code, 0) << share.errors;
  const Outcome angle = steps("45 deg");
  EXPECT_EQ(angle.exit_code, 2) << "its commands are shares of a range, not angles";
  EXPECT_THAT(angle.errors, HasSubstr("deg"));
}

}  // namespace
}  // namespace lacuna
