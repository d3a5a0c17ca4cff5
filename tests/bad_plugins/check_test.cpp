#include "end_to_end/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>

/// What `lacuna plugins check` tells of broken libraries: one sentence where the fault is, and the program goes on.
namespace lacuna {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

std::string library(const std::string& name) {
  return std::string(LACUNA_BINARY_DIRECTORY) + "/tests/bad_plugins/" + name + ".so";
}

/// Checks a library and keeps what was told of its components.
class CheckedLibrary {
 public:
  explicit CheckedLibrary(const std::string& name, const std::string& before = "") {
    outcome_ = program_.shell(before + "lacuna plugins check --json " + library(name));
    told_ = json::parse(outcome_.output, nullptr, false);
  }

  const Outcome& outcome() const { return outcome_; }
  const json& told() const { return told_; }
  /// "passed", "failed: FINDING" or "not applicable" of a component's check.
  std::string of(const std::string& component, const std::string& check) const {
    for (const json& result : checks_of(component))
      if (result.at("check") == check) return text_of(result);
    return "no such check";
  }
  /// The names of the checks that a component failed.
  std::vector<std::string> failed(const std::string& component) const {
    std::vector<std::string> names;
    for (const json& result : checks_of(component))
      if (result.at("outcome") == "failed") names.push_back(result.at("check"));
    return names;
  }

 private:
  json checks_of(const std::string& component) const {
    for (const json& one : told_.at("components"))
      if (one.at("name") == component) return one.at("checks");
    return json::array();
  }
  static std::string text_of(const json& result) {
    const std::string outcome = result.at("outcome");
    return outcome == "failed" ? outcome + ": " + result.at("finding").get<std::string>() : outcome;
  }

  Program program_;
  Outcome outcome_;
  json told_;
};

TEST(CheckedPlugin, WaversInOneWayEach) {
  const CheckedLibrary checked("wavering");
  EXPECT_EQ(checked.outcome().exit_code, 1);
  EXPECT_THAT(checked.outcome().errors, HasSubstr("7 components failed"));
  EXPECT_THAT(checked.of("counts_its_calls", "determinism"),
              HasSubstr("add_loads returned other numbers the second time"));
  EXPECT_THAT(checked.of("knows_its_process", "determinism"), HasSubstr("another process receives other numbers"));
  EXPECT_THAT(checked.of("knows_of_others", "two threads"),
              HasSubstr("add_loads returned other numbers while another thread called"));
  EXPECT_THAT(checked.of("divides_by_zero", "finite numbers"),
              HasSubstr("add_loads returned infinity at the values 0 of its parameters"));
  EXPECT_THAT(checked.of("throws_at_the_bound", "finite numbers"), HasSubstr("std::domain_error (too large)"));
  EXPECT_THAT(checked.of("hoarding_metric", "allocation"), HasSubstr("add allocates memory"));
  EXPECT_THAT(checked.of("hoarding_metric", "promises"), HasSubstr("at samples without a measurement"));
  EXPECT_THAT(checked.of("leaves_the_bounds", "promises"), HasSubstr("a child does not match the layout: mass = "));
}

TEST(CheckedPlugin, IsNotBlamedForWhatItDoesNot) {
  const CheckedLibrary checked("wavering");
  const std::map<std::string, std::vector<std::string>> failures = {
      {"knows_its_process", {"determinism"}},  {"knows_of_others", {"two threads"}},
      {"divides_by_zero", {"finite numbers"}}, {"throws_at_the_bound", {"finite numbers"}},
      {"leaves_the_bounds", {"promises"}},     {"sound", {}}};
  for (const auto& [name, expected] : failures) EXPECT_EQ(checked.failed(name), expected) << name;
}

TEST(CheckedPlugin, ThatEndsOrHoldsTheProgramTakesOnlyAChildWithIt) {
  const CheckedLibrary checked("ending");
  EXPECT_EQ(checked.outcome().exit_code, 1);
  EXPECT_THAT(checked.of("aborts", "promises"), HasSubstr("add_loads ended the program by signal 6 (Aborted)"));
  EXPECT_EQ(checked.of("aborts", "determinism"), "not applicable");
  EXPECT_THAT(checked.of("hangs", "promises"), HasSubstr("add_loads took longer than 10 s"));
}

TEST(CheckedPlugin, ThatDoesInHooksWhatIsForbidden) {
  const CheckedLibrary checked("ill_behaved");
  EXPECT_THAT(checked.of("allocates", "allocation"), HasSubstr("add_loads allocates memory, once per call"));
  EXPECT_THAT(checked.of("replaces_the_list", "promises"), HasSubstr("replaces the list of loads"));
  EXPECT_THAT(checked.of("overwrites_others", "promises"), HasSubstr("overwrites loads"));
  EXPECT_THAT(checked.of("reads_beyond", "promises"), HasSubstr("reads beyond its parameters"));
  EXPECT_THAT(checked.of("writes_beyond", "promises"), HasSubstr("writes beyond its state"));
  EXPECT_THAT(checked.of("rounds", "promises"), HasSubstr("changed the rounding"));
}

TEST(CheckedPlugin, ThatGivesNoNumbers) {
  const CheckedLibrary checked("not_a_number");
  for (const char* effect : {"nan_load", "nan_command", "nan_reading"})
    EXPECT_THAT(checked.of(effect, "finite numbers"), HasSubstr("returned NaN")) << effect;
  EXPECT_THAT(checked.of("nan_default", "declarations"), HasSubstr("not finite numbers"));
  EXPECT_THAT(checked.of("nan_robot", "promises"), HasSubstr("no engine can simulate the robot"));
}

TEST(CheckedPlugin, ThatThrowsNamesWhatAndWhatToDo) {
  const CheckedLibrary checked("throwing");
  EXPECT_THAT(checked.of("throws_in_factory", "declarations"), HasSubstr("std::runtime_error (no licence found)"));
  EXPECT_THAT(checked.of("throws_when_described", "declarations"), HasSubstr("rig::Trouble"));
  EXPECT_THAT(checked.of("throws_in_step", "determinism"), HasSubstr("rig::Trouble"));
  EXPECT_THAT(checked.of("throws_in_build", "promises"), HasSubstr("rig::Trouble"));
  for (const json& component : checked.told().at("components"))
    for (const json& result : component.at("checks"))
      EXPECT_EQ(result.at("outcome") == "failed", result.contains("why") && result.contains("do")) << result;
}

TEST(CheckedPlugin, ThatIsNoPluginFailsTheHandshake) {
  const std::map<std::string, std::string> sentences = {{"other_version", "version 0 of the plugin interface"},
                                                        {"other_layout", "lays out"},
                                                        {"missing_symbol", "has no function lacuna_plugin"},
                                                        {"dies_on_load", "when it was loaded"}};
  for (const auto& [name, sentence] : sentences) {
    const CheckedLibrary checked(name);
    EXPECT_EQ(checked.outcome().exit_code, 1) << name;
    EXPECT_FALSE(checked.told().at("passed").get<bool>()) << name;
    EXPECT_THAT(checked.told().at("handshake").at("finding").get<std::string>(), HasSubstr(sentence)) << name;
    EXPECT_TRUE(checked.told().at("components").empty()) << name;
  }
}

TEST(CheckedPlugin, ThatEndsTheProgramWhenItIsDescribedIsReported) {
  const CheckedLibrary checked("hostile", "export HOSTILE='describe segfault'; ");
  EXPECT_EQ(checked.outcome().exit_code, 1);
  EXPECT_THAT(checked.of("hostile", "declarations"), HasSubstr("ended the program by signal 11"));
}

TEST(CheckedPlugin, ATableSaysWhyAndWhatToDo) {
  const Program program;
  const Outcome outcome = program.run({"plugins", "check", library("ill_behaved")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output, AllOf(HasSubstr("handshake"), HasSubstr("effect sound\n"), HasSubstr("FAILED"),
                                    HasSubstr("why: "), HasSubstr("do:  ")));
}

TEST(CheckedPlugin, AFileThatIsNotThereIsBadInput) {
  const Program program;
  const Outcome outcome = program.run({"plugins", "check", "nowhere.so"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("nowhere.so: there is no such library"));
}

}  // namespace
}  // namespace lacuna
