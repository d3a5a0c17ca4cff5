#include "end_to_end/printed_lines.h"
#include "end_to_end/program.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <map>

namespace lacuna {
namespace {

/// Length of the longest text below `key`.
int longest(const nlohmann::json& components, const std::string& key) {
  std::size_t length = 0;
  for (const nlohmann::json& component : components)
    length = std::max(length, component[key].get<std::string>().size());
  return static_cast<int>(length);
}

TEST(PluginsList, HasKindNameAndSummaryInColumnsAndTheFileBelowTheSummaryWhenAsked) {
  const Program program;
  const Outcome json = program.run({"plugins", "list", "--json"});
  ASSERT_EQ(json.exit_code, 0) << json.errors;
  const nlohmann::json components = nlohmann::json::parse(json.output)["components"];
  const int kind = longest(components, "kind"), name = longest(components, "name");
  ASSERT_EQ(kind, static_cast<int>(std::string("objective metric").size()));

  std::vector<std::string> brief, verbose;
  for (const nlohmann::json& component : components) {
    const auto text = [&](const char* key) { return component[key].get<std::string>(); };
    brief.push_back(fmt::format("{:<{}}  {:<{}}  {}", text("kind"), kind, text("name"), name, text("summary")));
    verbose.push_back(brief.back());
    verbose.push_back(fmt::format("{:<{}}{}", "", kind + name + 4, text("file")));
  }
  EXPECT_THAT(lines_of(program.run({"plugins", "list"}).output), testing::ElementsAreArray(brief));
  EXPECT_THAT(lines_of(program.run({"plugins", "list", "--verbose"}).output), testing::ElementsAreArray(verbose));
}

TEST(PluginsList, HasOneKindWhereItIsAskedFor) {
  const Program program;
  const std::vector<std::string> robots = lines_of(program.run({"plugins", "list", "--kind", "robot"}).output);
  EXPECT_THAT(robots, testing::SizeIs(3));
  EXPECT_THAT(robots, testing::Each(testing::StartsWith("robot  ")));
  const Outcome outcome = program.run({"plugins", "list", "--kind", "search", "--json"});
  const nlohmann::json listed = nlohmann::json::parse(outcome.output);
  EXPECT_FALSE(listed.at("components").empty());
  for (const nlohmann::json& component : listed.at("components")) EXPECT_EQ(component.at("kind"), "search");
}

TEST(PluginsNew, RefusesWhatCannotBeANameWithASentence) {
  const std::map<std::string, std::string> sentences = {
      {"metric Water-Drag", "\"Water-Drag\" is not a valid plugin name; use lower-case letters, digits and _"},
      {"metric 2nd", "is not a valid plugin name"},
      {"robot " + std::string(101, 'a'), "the name has 101 letters; at most 100 are allowed"},
      {"search test", "test is a CMake target of every project"},
      {"search all_plugins", "or of Lacuna; choose another name"},
      {"metric mean_absolute_difference", "metric mean_absolute_difference already exists in "},
      {"recording-format csv", "Lacuna reads files that end with .csv without a plugin"},
      {"robot-format toml", "Lacuna reads files that end with .toml without a plugin"}};
  const Program program;
  for (const auto& [words, sentence] : sentences) {
    const Outcome outcome = program.shell("lacuna plugins new " + words);
    EXPECT_EQ(outcome.exit_code, 2) << words;
    EXPECT_THAT(outcome.errors, testing::HasSubstr(sentence)) << words;
  }
  EXPECT_TRUE(std::filesystem::is_empty(program.folder()));
}

TEST(PluginsNew, OverwritesNothing) {
  const Program program;
  ASSERT_EQ(program.shell("lacuna plugins new robot rod --into mine").exit_code, 0);
  program.write("mine/rod/rod.cpp", "my own work\n");
  program.write("file", "mine\n");
  for (const char* words : {"robot rod --into mine", "metric file"}) {
    const Outcome outcome = program.shell(std::string("lacuna plugins new ") + words);
    EXPECT_EQ(outcome.exit_code, 2) << words;
    EXPECT_THAT(outcome.errors, testing::HasSubstr("already exists and is not overwritten")) << words;
  }
  EXPECT_EQ(program.read("mine/rod/rod.cpp"), "my own work\n");
}

TEST(TargetOfAPlugin, ThatIsNotThereIsNamedAtItsPlace) {
  const Program program;
  program.copy_first_steps();
  program.write("rig.toml",
                "[experiment]\nname = \"rig\"\n[target]\nkind = \"simulatd\"\n[model]\n"
                "file = \"robots/servo-pendulum.toml\"\neffects = []\n");
  const Outcome outcome = program.run({"check", "rig.toml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, testing::HasSubstr("rig.toml:4:8: target.kind: there is no target \"simulatd\" (did you "
                                                 "mean \"simulated\"?)"));
}

}  // namespace
}  // namespace lacuna
