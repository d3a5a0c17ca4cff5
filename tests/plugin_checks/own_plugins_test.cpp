#include "end_to_end/program.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <set>

/// Every plugin of this build passes every check.
namespace lacuna {
namespace {

using nlohmann::json;

constexpr int kShards = 8;  // that run beside each other

std::vector<std::string> own_libraries() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(LACUNA_BINARY_DIRECTORY "/lib/lacuna/plugins"))
    if (entry.path().extension() == ".so") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

/// What formats are given besides.
std::string options_for(const std::string& library) {
  const std::map<std::string, std::string> samples = {
      {"json_lines", ""}, {"mat", "run.mat"}, {"numpy", "run.npz"}, {"rosbag2", "run.db3"}};
  const std::string name = std::filesystem::path(library).stem().string();
  const auto sample = samples.find(name);
  std::string options = " --carry-out";
  if (sample != samples.end())
    options +=
        " --sample " +
        (sample->second.empty() ? "rows.jsonl" : LACUNA_SOURCE_DIRECTORY "/tests/plugins/recordings/" + sample->second);
  return options;
}

class OwnPlugins : public testing::TestWithParam<int> {};

TEST_P(OwnPlugins, PassEveryCheck) {
  const std::vector<std::string> libraries = own_libraries();
  const Program program;
  program.write("rows.jsonl", "{\"t\": 0.0, \"q\": [0.1, 0.2]}\n{\"t\": 0.1, \"q\": [0.3, null]}\n");
  for (std::size_t i = static_cast<std::size_t>(GetParam()); i < libraries.size(); i += kShards) {
    const Outcome outcome = program.shell("lacuna plugins check " + libraries[i] + options_for(libraries[i]));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output << outcome.errors;
  }
}

INSTANTIATE_TEST_SUITE_P(Shards, OwnPlugins, testing::Range(0, kShards));

/// A check that silently did nothing would pass: of one plugin of each kind, what was seen.
TEST(OwnPluginsOfEachKind, AreSeenAtWork) {
  const std::map<std::string, std::string> kinds = {{"effect", "coulomb_friction"},
                                                    {"robot", "quadruped"},
                                                    {"robot format", "urdf"},
                                                    {"recording format", "numpy"},
                                                    {"target", "simulated"},
                                                    {"metric", "mean_absolute_difference"},
                                                    {"model encoding", "parameters"},
                                                    {"test encoding", "command_series"},
                                                    {"mutation", "gaussian"},
                                                    {"search", "truncation"},
                                                    {"test fitness", "model_disagreement"},
                                                    {"objective metric", "parameter_error"}};
  const Program program;
  for (const auto& [kind, name] : kinds) {
    const std::string library = LACUNA_BINARY_DIRECTORY "/lib/lacuna/plugins/" + name + ".so";
    const Outcome outcome = program.shell("lacuna plugins check --json " + library + options_for(library));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output << outcome.errors;
    const json component = json::parse(outcome.output).at("components").at(0);
    EXPECT_EQ(component.at("kind"), kind);
    std::set<std::string> passed;
    for (const json& result : component.at("checks"))
      if (result.at("outcome") == "passed") passed.insert(result.at("check").get<std::string>());
    EXPECT_THAT(passed, testing::IsSupersetOf({"declarations", "promises", "determinism", "finite numbers"})) << kind;
    for (const json& result : component.at("checks"))
      if (result.at("check") == "determinism")
        EXPECT_THAT(result.at("finding").get<std::string>(), testing::HasSubstr("and in another process")) << kind;
  }
}

}  // namespace
}  // namespace lacuna
