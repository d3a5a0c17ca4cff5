#include "app/workspace/component_details.h"
#include "config/experiment_reader.h"
#include "eea/small_run.h"
#include "evaluation/model/model_definition.h"
#include "foundation/placement_unit.h"
#include "plugins/built_catalog.h"
#include "support/test_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <set>

/// What the READMEs of plugins say is true: their tables are the declarations, their snippets run.
namespace lacuna {
namespace {

using testing::HasSubstr;

const std::filesystem::path kSource = LACUNA_SOURCE_DIRECTORY;

constexpr const char* kTarget = R"(
[target]
kind = "recorded"
files = ["data/servo_pendulum/sine.csv"]
time = { column = "t_s" }
sensors = { angle = { column = "angle_deg", unit = "deg" } }
commands = { motor = { column = "torque_Nm", unit = "N*m" } }
)";
constexpr const char* kModel = "[model]\nfile = \"robots/servo-pendulum.toml\"\n";

/// Where plugins of a kind stand.
std::string folder_of(const std::string& kind) {
  static const std::map<std::string, std::string> unusual = {{"model encoding", "encodings"},
                                                             {"test encoding", "encodings"},
                                                             {"search", "searches"},
                                                             {"robot format", "robot_formats"},
                                                             {"recording format", "recording_formats"},
                                                             {"test fitness", "test_fitness"},
                                                             {"objective metric", "objectives"}};
  const auto found = unusual.find(kind);
  return found == unusual.end() ? kind + "s" : found->second;
}

std::string readme_of(const PluginListing& listing) {
  return read_bytes(kSource / "plugins" / folder_of(listing.kind) / listing.name / "README.md");
}

ParameterDeclarations parameters_of(const PluginListing& listing) {
  for (const ComponentDetails& details : details_of(built_catalog(), listing.name))
    if (details.listing.kind == listing.kind) return details.parameters;
  throw Error("no details of " + listing.name);
}

/// The block of that language, which a README has once.
std::string snippet(const std::string& readme, const std::string& language) {
  const std::string fence = "```" + language + "\n";
  const std::size_t start = readme.find(fence);
  if (start == std::string::npos) return {};
  return readme.substr(start + fence.size(), readme.find("```", start + fence.size()) - start - fence.size());
}

/// As if the text stood in a file of the folder `experiments`.
void check_experiment(const std::string& text) {
  const Experiment experiment =
      read_experiment_text("[experiment]\nname = \"readme\"\n" + text, kSource / "experiments" / "readme.toml");
  define_model(experiment, built_catalog());
}

TEST(Readme, EveryPluginHasOneWithItsParameterTable) {
  for (const PluginListing& listing : built_catalog().list()) {
    const std::string readme = readme_of(listing);
    EXPECT_THAT(readme, testing::StartsWith("# " + listing.name + "\n"));
    for (const ParameterDeclaration& parameter : parameters_of(listing))
      EXPECT_THAT(readme, HasSubstr(fmt::format("| `{}` | {} | {:g} | {:g} | {:g} | {} |", parameter.name,
                                                unit_in_words(parameter.unit), parameter.default_value, parameter.lower,
                                                parameter.upper, parameter.description)));
  }
}

TEST(Readme, EveryOneShowsItsPluginAtWork) {
  for (const PluginListing& listing : built_catalog().list()) {
    if (listing.name == "declared") continue;         // its snippet is a robot file
    if (listing.kind.ends_with(" format")) continue;  // a file's ending names it
    EXPECT_THAT(snippet(readme_of(listing), "toml"), HasSubstr("\"" + listing.name + "\""));
  }
}

TEST(Readme, SnippetsOfEffectsAndRobotsAreModels) {
  for (const PluginListing& listing : built_catalog().list()) {
    if (listing.kind != "effect" && listing.name != "quadruped") continue;
    const std::string model = snippet(readme_of(listing), "toml");
    EXPECT_THAT(model, HasSubstr(listing.name));
    EXPECT_NO_THROW(check_experiment(kTarget + model)) << model;
  }
}

TEST(Readme, TheDeclaredRobotsSnippetIsARobotFile) {
  const TestFolder folder;
  const std::string robot = snippet(read_bytes(kSource / "plugins/robots/declared/README.md"), "toml");
  const std::filesystem::path file = folder.write("robot.toml", robot);
  EXPECT_NO_THROW(check_experiment(kTarget + ("[model]\nfile = \"" + file.string() + "\"\n")));
}

TEST(Readme, TheRecordedTargetsSnippetIsATarget) {
  const std::string target = snippet(read_bytes(kSource / "plugins/targets/recorded/README.md"), "toml");
  EXPECT_NO_THROW(check_experiment(target + kModel));
}

/// Tables of a run of the quadruped, for those that a snippet does not bring itself.
const std::map<std::string, std::string> kTablesOfRun = {
    {"target",
     "kind = \"simulated\"\nrobot = \"quadruped\"\nhidden = { \"body.*.mass\" = { uniform = [1.0, 7.0] } }\n"},
    {"model", "robot = \"quadruped\"\nfree = { \"body.*.mass\" = [1.0, 7.0] }\n"},
    {"engine", "step = 0.01\n"},
    {"estimation", "parameters = { population = 4, keep = 2, generations = 2 }\n"},
    {"exploration", "parameters = { population = 4, keep = 2, generations = 2 }\n"}};

/// The snippet as a whole experiment of one pass.
std::string experiment_of(const std::string& snippet) {
  std::string text = "[experiment]\nname = \"readme\"\npasses = 1\n" + snippet;
  for (const auto& [table, keys] : kTablesOfRun)
    if (snippet.find("[" + table + "]\n") == std::string::npos) text += fmt::format("[{}]\n{}", table, keys);
  return text;
}

TEST(Readme, SnippetsOfTheAlgorithmsPluginsRun) {
  const std::set<std::string> others = {"effect", "robot", "robot format", "recording format"};
  std::set<std::string> kinds;
  for (const PluginListing& listing : built_catalog().list()) {
    if (others.contains(listing.kind) || listing.name == "recorded") continue;
    SCOPED_TRACE(listing.kind + " " + listing.name);
    kinds.insert(listing.kind);
    const std::string text = experiment_of(snippet(readme_of(listing), "toml"));
    const MemoryJournal journal = run(*small_bench({"test.duration=0.05"}, text));
    ASSERT_EQ(journal.passes.size(), 1U) << text;
    EXPECT_TRUE(std::isfinite(journal.passes.front().best_score)) << text;
    EXPECT_FALSE(journal.tests.empty()) << text;
  }
  EXPECT_EQ(kinds.size(), 8U) << "a kind of component is not looked at";
}

}  // namespace
}  // namespace lacuna
