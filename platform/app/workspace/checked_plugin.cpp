#include "app/workspace/checked_plugin.h"

#include "app/terminal/options.h"
#include "app/terminal/output.h"
#include "app/terminal/scratch_folder.h"
#include "foundation/processes/child_program.h"
#include "foundation/text/counted.h"
#include "foundation/text/problem.h"
#include "plugin_checks/plugin_check.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>

namespace lacuna {
namespace {

/// In the environment of the other process, which then prints digests alone.
constexpr const char* kPrintDigests = "LACUNA_PRINT_PLUGIN_DIGESTS";
constexpr double kSecondsOfDigests = 300.0;

struct CheckPluginOptions {
  std::filesystem::path file;
  std::filesystem::path sample;
  std::optional<std::string> json;
  bool carry_out = false;
};

/// Throws `BadInput` for a name that leads to no file.
std::filesystem::path existing(const char* what, const std::filesystem::path& file) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(file, unknown))
    throw_problem({file.string(), 0, 0}, std::string("there is no such ") + what + "; check the path");
  return std::filesystem::absolute(file).lexically_normal();
}

/// The digests of this program once more, in a process that shares nothing with this one; none where that fails.
TranscriptDigests digests_of_other_process(const CheckPluginOptions& options) {
  const CapturedOutput output("digests of a plugin");
  ChildBeginning beginning;
  beginning.words = {"/proc/self/exe", "plugins", "check", options.file.string()};
  if (!options.sample.empty()) beginning.words.insert(beginning.words.end(), {"--sample", options.sample.string()});
  if (options.carry_out) beginning.words.emplace_back("--carry-out");
  beginning.environment[kPrintDigests] = "1";
  beginning.output = output.file();
  ChildProgram child(beginning);
  if (!child.ended_within(kSecondsOfDigests)) return {};
  try {
    return nlohmann::json::parse(output.end()).get<TranscriptDigests>();
  } catch (const nlohmann::json::exception&) {
    return {};
  }
}

void check_plugin_file(CheckPluginOptions options) {
  options.file = existing("library", options.file);
  if (!options.sample.empty()) options.sample = existing("sample", options.sample);
  check_output(options.json);
  const ScratchFolder scratch;
  const ExerciseInputs inputs = {options.sample, scratch.path(), options.carry_out};
  if (std::getenv(kPrintDigests) != nullptr) {
    fmt::print("{}\n", nlohmann::json(transcript_digests(options.file, inputs)).dump());
    return;
  }
  const PluginChecks checks = check_plugin(options.file, inputs, [&] { return digests_of_other_process(options); });
  if (options.json)
    write_output(*options.json, json_of(checks).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  if (!takes_standard_output(options.json)) std::fputs(text_of(checks).c_str(), stdout);
  std::fflush(stdout);
  if (checks.passed()) return;
  const auto bad =
      static_cast<std::size_t>(std::count_if(checks.components.begin(), checks.components.end(),
                                             [](const ComponentChecks& component) { return !component.passed(); }));
  throw Error(fmt::format("{}: {} failed; repair the plugin where the output says FAILED", options.file.string(),
                          checks.components.empty() ? "the handshake" : counted(bad, "component")));
}

}  // namespace

void add_check_plugin_command(CLI::App& plugins) {
  auto options =
      std::make_shared<CheckPluginOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* check = plugins.add_subcommand("check", "Test a plugin file: call its functions in separate processes");
  check->add_option("file", options->file, "The plugin file")->required()->option_text("FILE.so");
  check->add_option("--sample", options->sample, "Valid file of the format that the plugin reads")->option_text("FILE");
  check->add_flag("--carry-out", options->carry_out, "Let targets carry out a test (a real rig moves)");
  add_result_option(*check, "json", options->json, "Write results as JSON to FILE (default: standard output)");
  check->callback([options] { check_plugin_file(*options); });
}

}  // namespace lacuna
