#include "app/component_details.h"
#include "config/experiment_reader.h"
#include "evaluation/model_definition.h"
#include "foundation/placement_unit.h"
#include "support/test_folder.h"
#include "plugins/built_catalog.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdlib>
#include <map>

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
    if (listing.name == "declared") continue;  // its snippet is a robot file
    const std::string readme = readme_of(listing);
    EXPECT_THAT(snippet(readme, "toml") + snippet(readme, "console"), HasSubstr(listing.name));
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

TEST(Readme, TheMetricsSnippetIsACommand) {
  const std::string readme = read_bytes(kSource / "plugins/metrics/mean_absolute_difference/README.md");
  const std::string command = snippet(readme, "console");
  ASSERT_THAT(command, testing::StartsWith("$ lacuna "));
  const std::string call = LACUNA_BINARY_DIRECTORY "/bin/" + command.substr(2, command.size() - 3) + " > /dev/null";
  EXPECT_EQ(std::system(call.c_str()), 0) << call;
}

}  // namespace
}  // namespace lacuna
