#include "bad_plugins/hostile_plugin.h"
#include "support/sanitizers.h"

#include <regex>
#include <string>
#include <utility>
#include <vector>

/// A plugin that ends the process that calls it: the command fails, with a line that names plugin and call, and the
/// database is as it was.
namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST_F(HostilePlugin, ThatEndsTheProgramInAStepIsNamed) {
  ASSERT_EQ(lacuna("", "compare rig.toml").exit_code, 0);
  const auto error = [&] {
    const std::string history = program_.run({"history", "rig.toml"}).output;
    std::smatch match;
    return std::regex_search(history, match, std::regex("rigid +([0-9.]+ .?.?rad)")) ? match[1].str() : history;
  };
  const std::string before = error();
  ASSERT_THAT(before, testing::EndsWith("rad"));
  for (const auto& [order, what] : {std::pair{"add_loads exit", "add_loads ended the program with exit code 0"},
                                    std::pair{"add_loads _exit", "add_loads ended the program with exit code 0"},
                                    std::pair{"add_loads abort", "add_loads ended the program by signal 6"},
                                    std::pair{"add_loads terminate 20", "add_loads ended the program by signal 6"},
                                    std::pair{"describe exit 2", "describe ended the program with exit code 0"},
                                    std::pair{"stages _exit 2", "stages ended the program with exit code 0"}}) {
    const Outcome outcome = lacuna(order, compare("hostile"));
    EXPECT_EQ(outcome.exit_code, 1) << order;
    EXPECT_THAT(outcome.errors, names("effect \"hostile\"", what)) << order;
  }
  EXPECT_THAT(program_.run({"sql", "wheel.db", "PRAGMA integrity_check"}).output, HasSubstr("ok"));
  EXPECT_EQ(error(), before);
}

TEST_F(HostilePlugin, ThatCrashesInAStepIsNamed) {
  if (LACUNA_WATCHED) GTEST_SKIP() << "the sanitizer makes an exit code of its own of a crash";
  const Outcome crash = lacuna("add_loads segfault", compare("hostile"));
  EXPECT_EQ(crash.exit_code, 1);
  EXPECT_THAT(crash.errors, names("effect \"hostile\"", "add_loads ended the program by signal 11"));
}

TEST_F(HostilePlugin, ThatIsKilledIsNamedAndNotBlamed) {
  const Outcome outcome = lacuna("add_loads kill", compare("hostile"));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.errors, AllOf(HasSubstr("hostile.so): add_loads"), HasSubstr("was ended by signal 9"),
                                    HasSubstr("memory"), Not(HasSubstr("fault of the plugin"))));
}

TEST_F(HostilePlugin, ThatTakesAllMemoryOrThrowsIsNamed) {
  const Outcome foreign = lacuna("add_loads throw", compare("hostile"));
  EXPECT_EQ(foreign.exit_code, 1);
  EXPECT_THAT(foreign.errors, HasSubstr("add_loads threw an object of type"));
  if (LACUNA_WATCHED) GTEST_SKIP() << "a sanitizer needs more address space than this leaves";
  const Outcome hog = program_.shell("ulimit -v 2000000; export HOSTILE='add_loads hog'; lacuna " + compare("hostile") +
                                     " --plugin-path " + folder_.path().string());
  EXPECT_EQ(hog.exit_code, 1);
  EXPECT_THAT(hog.errors, AllOf(HasSubstr("hostile.so"), HasSubstr("add_loads ran out of memory")));
}

TEST_F(HostilePlugin, ThatEndsADiagnosisIsNamed) {
  program_.copy_first_steps();
  const Outcome outcome = lacuna("add_loads exit", "diagnose first-steps.toml --among hostile");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.output;
  EXPECT_THAT(outcome.errors, names("effect \"hostile\"", "add_loads ended the program with exit code 0"));
}

TEST_F(HostilePlugin, ThatEndsARunIsNamed) {
  const Outcome search = lacuna("begin exit",
                                "run small.toml --set 'estimation.search=\"hostile_search\"'"
                                " --set 'estimation.parameters={}'");
  EXPECT_EQ(search.exit_code, 1);
  EXPECT_THAT(search.errors, names("search \"hostile_search\"", "begin ended the program with exit code 0"));
  const Outcome metric = lacuna("add abort", "run small.toml --set 'estimation.metric=\"hostile_metric\"' --threads 2");
  EXPECT_EQ(metric.exit_code, 1);
  EXPECT_THAT(metric.errors, AllOf(HasSubstr("metric \"hostile_metric\""), HasSubstr("has ended 3 worker processes"),
                                   HasSubstr("add ended the program by signal 6")));
  const Outcome in_host =
      lacuna("add abort", "run small.toml --set 'estimation.metric=\"hostile_metric\"' --threads 2 --no-isolate");
  EXPECT_EQ(in_host.exit_code, 1);
  EXPECT_THAT(in_host.errors, names("metric \"hostile_metric\"", "add ended the program by signal 6"));
}

/// The ways in which a hostile effect ends a process, and how that is told.
const std::vector<std::pair<std::string, std::string>> kDeeds = {
    {"exit", "add_loads ended the program with exit code 0"},
    {"_exit", "add_loads ended the program with exit code 0"},
    {"abort", "add_loads ended the program by signal 6"},
    {"segfault", "add_loads ended the program by signal 11"},
    {"stack", "add_loads ended the program by signal 11"},
    {"thread", "add_loads ended the program by signal 6"},
    {"hang", "add_loads: an evaluation took longer than the limit, 1 s"},
    {"throw", "add_loads threw an object of type"},
    {"hog", "add_loads ran out of memory"},
};

/// Short where the limit is what ends the deed; others may need time for it on a slow machine.
std::string limit_of(const std::string& deed) { return deed == "hang" ? " --evaluation-limit 1" : ""; }

/// A run of the quadruped whose models have the hostile effect.
class HostileEffectInARun : public HostilePlugin {
 protected:
  HostileEffectInARun() {
    std::string text = program_.read("small.toml");
    text.insert(text.find("[engine]"), "effects = [{ effect = \"hostile\", where = \"joint.front_left_hip\" }]\n\n");
    program_.write("small.toml", text);
  }
  /// `order`: see hostile.cpp. Begins with little memory, so that little is taken before there is none left.
  Outcome lacuna_with_hostile(const std::string& order, const std::string& command) const {
    return program_.shell("ulimit -d 1000000; export HOSTILE='" + order + "'; lacuna " + command + " --plugin-path " +
                          folder_.path().string() + " --quiet");
  }
  Outcome run(const std::string& order, const std::string& options) const {
    return lacuna_with_hostile(order, "run small.toml " + options);
  }
  std::string reasons() const {
    return program_.run({"sql", "small.db", "SELECT reason FROM invalid_evaluations", "--csv"}).output;
  }
};

TEST_F(HostileEffectInARun, CostsOneModelWhereItRunsInAWorkerProcess) {
  if (LACUNA_WATCHED) GTEST_SKIP() << "a sanitizer makes exit codes of its own of crashes, and needs address space";
  for (const auto& [deed, what] : kDeeds) {
    program_.shell("rm -f small.db* once");
    const std::string order = "add_loads " + deed + " 60";
    const Outcome outcome = run(order + "'; export HOSTILE_ONCE='once", limit_of(deed));
    ASSERT_EQ(outcome.exit_code, 0) << deed << outcome.errors;
    EXPECT_THAT(reasons(), AllOf(HasSubstr("effect \"\"hostile\"\""), HasSubstr(what))) << deed;
    EXPECT_EQ(program_.run({"verify", "small.db"}).exit_code, 0) << deed;
  }
}

TEST_F(HostileEffectInARun, EndsTheRunWhereItHasEndedThreeWorkers) {
  if (LACUNA_WATCHED) GTEST_SKIP() << "a sanitizer makes exit codes of its own of crashes";
  const Outcome outcome = run("add_loads segfault 50", "");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.errors,
              AllOf(HasSubstr("effect \"hostile\""), HasSubstr("has ended 3 worker processes"),
                    HasSubstr("by signal 11"), HasSubstr("--resume --accept-plugin hostile continues from here")));
  const Outcome mended = run("", "--resume");
  EXPECT_EQ(mended.exit_code, 0) << mended.errors;
}

/// The plugin is built anew: another file, of which the run knew nothing.
TEST_F(HostileEffectInARun, GoesOnWithTheMendedPluginByTheLineThatWasPrinted) {
  if (LACUNA_WATCHED) GTEST_SKIP() << "a sanitizer makes exit codes of its own of crashes";
  const std::filesystem::path plugin = folder_.path() / "hostile.so";
  const Outcome broken = run("add_loads segfault 50", "");
  ASSERT_EQ(broken.exit_code, 1);
  program_.shell("printf rebuilt >>" + plugin.string());  // behind what the loader reads
  const Outcome refused = run("", "--resume");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, AllOf(HasSubstr("was begun with another build of " + plugin.string()),
                                    HasSubstr("--accept-plugin hostile: the rows so far stay from the old build")));
  std::smatch line;
  ASSERT_TRUE(std::regex_search(broken.errors, line, std::regex("then (lacuna .*) continues from here")));
  const Outcome mended = program_.shell(line[1].str());
  EXPECT_EQ(mended.exit_code, 0) << mended.errors;
  EXPECT_THAT(mended.errors, HasSubstr("continues with another build of " + plugin.string()));
  EXPECT_EQ(program_.run({"verify", "small.db"}).exit_code, 0);
  EXPECT_THAT(program_
                  .run({"sql", "small.db", "--csv",
                        "SELECT count(*), count(DISTINCT sha256), sum(file LIKE '%hostile.so (until 20%)') "
                        "FROM plugin_file WHERE file LIKE '%hostile%'"})
                  .output,
              HasSubstr("\n2,2,1"));
  EXPECT_THAT(program_.shell("lacuna reproduce small.db --quiet --plugin-path " + folder_.path().string()).errors,
              HasSubstr("its rows come from both builds"));
}

TEST_F(HostileEffectInARun, AcceptsNoPluginThatTheExperimentDoesNotUse) {
  run("add_loads segfault 50", "");
  const Outcome slip = run("", "--resume --accept-plugin hostil");
  EXPECT_EQ(slip.exit_code, 2);
  EXPECT_THAT(slip.errors, AllOf(HasSubstr("--accept-plugin hostil: the experiment uses no plugin of that name"),
                                 HasSubstr("did you mean \"hostile\"?")));
}

TEST_F(HostileEffectInARun, IsNamedWhereThereAreNoWorkers) {
  if (LACUNA_WATCHED) GTEST_SKIP() << "a sanitizer makes exit codes of its own of crashes, and needs address space";
  for (const auto& [deed, what] : kDeeds) {
    program_.shell("rm -f small.db* once");
    const Outcome outcome =
        run("add_loads " + deed + " 60'; export HOSTILE_ONCE='once", "--no-isolate --threads 1" + limit_of(deed));
    if (outcome.exit_code != 0)
      EXPECT_THAT(outcome.errors, AllOf(HasSubstr("effect \"hostile\""), HasSubstr(what))) << deed;
    else  // what is thrown ends no process
      EXPECT_THAT(reasons(), AllOf(HasSubstr("effect \"\"hostile\"\""), HasSubstr(what))) << deed;
    EXPECT_THAT(program_.run({"sql", "small.db", "PRAGMA integrity_check"}).output, HasSubstr("ok")) << deed;
  }
}

TEST_F(HostileEffectInARun, IsNamedByAPrediction) {
  if (LACUNA_WATCHED) GTEST_SKIP() << "a sanitizer makes exit codes of its own of crashes, and needs address space";
  ASSERT_EQ(run("", "").exit_code, 0);
  for (const auto& [deed, what] : kDeeds) {
    const Outcome outcome = lacuna_with_hostile("add_loads " + deed, "predict small.toml --test 0" + limit_of(deed));
    EXPECT_EQ(outcome.exit_code, 1) << deed << outcome.output;
    EXPECT_THAT(outcome.errors, AllOf(HasSubstr("effect \"hostile\""), HasSubstr(what))) << deed;
  }
}

TEST_F(HostilePlugin, IsNamedByAFit) {
  if (LACUNA_WATCHED) GTEST_SKIP() << "a sanitizer makes exit codes of its own of crashes, and needs address space";
  for (const auto& [deed, what] : kDeeds) {
    const Outcome outcome = program_.shell(
        "ulimit -d 1000000; export HOSTILE='add_loads " + deed +
        "'; lacuna fit rig.toml --set 'model.effects=[{effect=\"hostile\",where=\"joint.axle\"}]' --plugin-path " +
        folder_.path().string() + limit_of(deed));
    EXPECT_EQ(outcome.exit_code, 1) << deed << outcome.output;
    EXPECT_THAT(outcome.errors, AllOf(HasSubstr("effect \"hostile\""), HasSubstr(what))) << deed;
  }
}

TEST_F(HostilePlugin, IsLeftOutOfADiagnosisThatGoesOn) {
  if (LACUNA_WATCHED) GTEST_SKIP() << "a sanitizer makes exit codes of its own of crashes";
  program_.copy_first_steps();
  for (const auto& [deed, what] :
       {std::pair{"segfault", "by signal 11"}, std::pair{"hang", "took longer than the limit, 2 s"}}) {
    program_.shell("rm -f *.db");
    const Outcome outcome =
        lacuna(std::string("add_loads ") + deed, "diagnose first-steps.toml --evaluation-limit 2 --quiet");
    EXPECT_EQ(outcome.exit_code, 0) << deed << outcome.errors;
    EXPECT_THAT(outcome.errors,
                AllOf(HasSubstr("effect \"hostile\""), HasSubstr(what), HasSubstr("starts again without it")));
    EXPECT_THAT(outcome.output, AllOf(HasSubstr("coulomb_friction"), HasSubstr("plugin failed: hostile"))) << deed;
  }
}

TEST_F(HostilePlugin, ThatThrowsInADiagnosisIsToldAsFailedNotAsUntestable) {
  program_.copy_first_steps();
  const Outcome outcome =
      lacuna("add_loads throw", "diagnose first-steps.toml --among hostile --among coulomb_friction --quiet");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, AllOf(HasSubstr("plugin failed: hostile @ "), HasSubstr("add_loads threw an object of"),
                                    HasSubstr("this is a fault of the plugin"), Not(HasSubstr("not testable"))));
}

TEST_F(HostilePlugin, ThatHangsEndsWithTheFirstWish) {
  for (const char* signal : {"TERM", "INT"}) {
    const Outcome outcome = lacuna("add_loads hang", "--version >/dev/null; timeout --signal " + std::string(signal) +
                                                         " 2 lacuna " + compare("hostile"));
    EXPECT_EQ(outcome.exit_code, 124) << "timeout's own";
    EXPECT_THAT(outcome.errors,
                AllOf(HasSubstr("interrupted; effect \"hostile\""), HasSubstr("did not return within two")));
  }
}

TEST_F(HostilePlugin, ThatEndsItsDescriptionIsListedAndTheOthersWork) {
  for (const std::string order : {"describe exit", "factory _exit", "stages abort"}) {
    const Outcome list = lacuna(order, "plugins list");
    EXPECT_EQ(list.exit_code, 0) << order;
    EXPECT_THAT(list.output, AllOf(HasSubstr("cannot be used: effect \"hostile\""), HasSubstr("ended the program"),
                                   HasSubstr("harmless_neighbour"), HasSubstr("coulomb_friction")));
    EXPECT_EQ(lacuna(order, compare("harmless_neighbour")).exit_code, 0) << order;
    const Outcome use = lacuna(order, compare("hostile"));
    EXPECT_EQ(use.exit_code, 2) << order;
    EXPECT_THAT(use.errors, AllOf(HasSubstr("model.effects[0].effect"), HasSubstr("ended the program")));
  }
}

TEST_F(HostilePlugin, WhoseDescriptionHangsIsListedAfterTheTimeLimit) {
  const Outcome list = lacuna("describe hang", "plugins list");
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_THAT(list.output, HasSubstr("hostile.so): describe took longer than 10 s; this is a fault of the plugin"));
}

}  // namespace
}  // namespace lacuna
