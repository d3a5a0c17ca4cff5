#include "bad_plugins/hostile_plugin.h"
#include "support/sanitizers.h"

#include <sys/stat.h>

#include <string>
#include <utility>

/// What the program does about plugins that change its process, never return, stop it, or end it outside of all calls.
namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class HostileRun : public HostilePlugin {
 protected:
  HostileRun() {
    std::string text = program_.read("small.toml");
    text.insert(text.find("[engine]"), "effects = [{ effect = \"hostile\", where = \"joint.front_left_hip\" }]\n\n");
    program_.write("with_effect.toml", text);
  }
  std::string hash(const std::string& database) const { return program_.run({"hash", database}).output; }
};

TEST_F(HostileRun, ThatOnlyLiesOnThePathChangesNoResult) {
  ASSERT_EQ(program_.run({"run", "small.toml", "--quiet"}).exit_code, 0);
  const std::string sound = hash("small.db");
  for (const std::string workers : {"", " --no-isolate"}) {
    for (const std::string deed : {"fesetround", "flush_denormals"}) {
      program_.shell("rm -f small.db*");
      const Outcome outcome = lacuna("load " + deed, "run small.toml --quiet" + workers);
      EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
      EXPECT_EQ(hash("small.db"), sound) << deed << workers;
      EXPECT_EQ(program_.run({"verify", "small.db"}).exit_code, 0);
    }
  }
}

TEST_F(HostileRun, ThatChangesTheArithmeticInAStepCostsTheModelAndIsNamed) {
  for (const std::string workers : {"", " --no-isolate"}) {
    program_.shell("rm -f with_effect.db* small.db* once");
    const Outcome outcome = lacuna("add_loads fesetround 60'; export HOSTILE_ONCE='once",
                                   "run with_effect.toml --db small.db --quiet" + workers);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    EXPECT_THAT(
        program_.run({"sql", "small.db", "SELECT reason FROM invalid_evaluations", "--csv"}).output,
        AllOf(HasSubstr("effect \"\"hostile\"\""), HasSubstr("add_loads changed the rounding of floating-point")))
        << workers;
  }
}

TEST_F(HostilePlugin, ThatChangesTheFolderInEarnestIsNamedAndTheDatabaseIsWhereItBelongs) {
  const Outcome outcome = lacuna_later("describe chdir", compare("hostile"));
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_THAT(outcome.errors, AllOf(HasSubstr("effect \"hostile\""), HasSubstr("the current folder (/)")));
  EXPECT_EQ(lacuna("", "compare rig.toml").exit_code, 0);
  EXPECT_THAT(program_.run({"sql", "wheel.db", "PRAGMA integrity_check"}).output, HasSubstr("ok"));
}

TEST_F(HostilePlugin, WhoseCallNeverReturnsIsEndedAndNamed) {
  for (const std::string call : {"amend", "state_size"}) {
    const Outcome outcome = lacuna(call + " hang", compare("hostile"));
    EXPECT_EQ(outcome.exit_code, 1) << call;
    EXPECT_THAT(outcome.errors,
                AllOf(HasSubstr("effect \"hostile\" (" + file() + "): " + call + " took longer than the limit, 10 s"),
                      HasSubstr("repair the plugin")));
  }
}

TEST_F(HostilePlugin, WhoseSecondDescriptionNeverReturnsHidesNoOther) {
  const Outcome list = lacuna_later("describe hang", "plugins list");
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_THAT(list.output,
              AllOf(HasSubstr("cannot be used: effect \"hostile\""),
                    HasSubstr("its summary took longer than the limit, 10 s"), HasSubstr("coulomb_friction")));
  EXPECT_THAT(list.errors, HasSubstr("the command starts again without it"));
}

TEST_F(HostilePlugin, WhoseSearchNeverBeginsIsEndedAndNamed) {
  const Outcome outcome = lacuna("begin hang",
                                 "run small.toml --evaluation-limit 1 --set 'estimation.search=\"hostile_search\"'"
                                 " --set 'estimation.parameters={}'");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.errors,
              HasSubstr("search \"hostile_search\" (" + file() + "): begin took longer than the limit, 10 s"));
}

TEST_F(HostilePlugin, ThatStopsTheProcessAgainAndAgainIsEndedAndNamed) {
  const Outcome outcome = lacuna("add_loads stop", compare("hostile"));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.errors, names("effect \"hostile\"", "add_loads stopped the program by signal 19 (SIGSTOP)"));
}

TEST_F(HostileRun, ThatStopsItsWorkersIsNamed) {
  const Outcome outcome = lacuna("add_loads stop 60", "run with_effect.toml --db small.db --quiet");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.errors, AllOf(HasSubstr("effect \"hostile\""), HasSubstr("SIGSTOP")));
}

TEST_F(HostilePlugin, WhoseThreadEndsTheProgramIsNamed) {
  if (LACUNA_WATCHED) GTEST_SKIP() << "the sanitizer makes an exit code of its own of a crash";
  const Outcome outcome = lacuna("add_loads abort_later",
                                 "fit rig.toml --set 'model.effects=[{effect=\"hostile\","
                                 "where=\"joint.axle\"}]' --set engine.step=1e-5");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.output;
  // Its effect may be in a call at that moment, which is named then.
  EXPECT_THAT(outcome.errors, AllOf(HasSubstr(file()), HasSubstr("ended the program by signal 6"),
                                    HasSubstr("fault of the plugin"), Not(HasSubstr("please report"))));
}

TEST_F(HostilePlugin, WhoseDestructorEndsTheProgramIsNamed) {
  if (LACUNA_WATCHED) GTEST_SKIP() << "the sanitizer makes an exit code of its own of a crash";
  const Outcome outcome =
      lacuna("destructor abort", "run small.toml --no-isolate --set 'estimation.metric=\"hostile_metric\"'");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.output;
  EXPECT_THAT(outcome.errors, AllOf(HasSubstr(file() + ": its code ended the program by signal 6"),
                                    HasSubstr("outside of all calls"), Not(HasSubstr("please report"))));
}

TEST_F(HostilePlugin, WhoseExceptionCannotSayWhatItIsIsNamed) {
  if (LACUNA_WATCHED) GTEST_SKIP() << "the sanitizer makes an exit code of its own of a crash";
  const Outcome outcome = lacuna("add_loads throw_unspeakable", compare("hostile"));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.errors, names("effect \"hostile\"", "add_loads ended the program by signal 6"));
}

TEST_F(HostilePlugin, ThatEndsTheThreadThatCallsItIsNamed) {
  if (LACUNA_WATCHED) GTEST_SKIP() << "the sanitizer makes an exit code of its own of a crash";
  for (const std::string call : {"add_loads", "state_size"}) {
    const Outcome outcome = lacuna(call + " pthread_exit", compare("hostile"));
    EXPECT_EQ(outcome.exit_code, 1) << call;
    EXPECT_THAT(outcome.errors, names("effect \"hostile\"", call + " ended its thread (pthread_exit)")) << call;
  }
}

TEST_F(HostilePlugin, WhoseExitHandlerFailsIsNamedAndTheWorkIsDone) {
  if (LACUNA_WATCHED) GTEST_SKIP() << "the sanitizer makes an exit code of its own of a crash";
  for (const auto& [deed, what] : {std::pair{"abort_at_exit", "was ended by signal 6"},
                                   std::pair{"hang_at_exit", "did not end within 10 s, and was ended,"}}) {
    program_.shell("rm -f wheel.db*");
    const Outcome outcome = lacuna(std::string("add_loads ") + deed, compare("hostile"));
    EXPECT_EQ(outcome.exit_code, 1) << deed;
    EXPECT_THAT(outcome.errors,
                AllOf(HasSubstr(what), HasSubstr("after its work was complete; no result is lost"), HasSubstr(file())))
        << deed;
    EXPECT_THAT(program_.run({"history", "rig.toml"}).output, HasSubstr("rad")) << deed;
  }
}

TEST_F(HostilePlugin, ThatHangsWhenItIsLoadedHidesNoOtherFromADiagnosis) {
  program_.copy_first_steps();
  const Outcome outcome = lacuna("load hang", "diagnose first-steps.toml --among coulomb_friction --quiet");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("coulomb_friction"));
}

TEST_F(HostilePlugin, WhoseTableFunctionThrowsIsListedWithItsFile) {
  const Outcome list = lacuna("lacuna_plugin throw", "plugins list");
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_THAT(list.errors, HasSubstr(file() + ": lacuna_plugin threw an object of type"));
  EXPECT_THAT(list.output, HasSubstr("coulomb_friction"));
}

TEST_F(HostilePlugin, BesideANamedPipeIsReadAtOnce) {
  ASSERT_EQ(mkfifo((folder_.path() / "pipe.so").c_str(), 0600), 0);
  const Outcome list = lacuna("", "plugins list");
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_THAT(list.errors, HasSubstr("pipe.so: is a named pipe, not a shared library"));
  EXPECT_THAT(list.output, HasSubstr("harmless_neighbour"));
}

}  // namespace
}  // namespace lacuna
