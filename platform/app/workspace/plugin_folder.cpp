#include "app/workspace/plugin_folder.h"

#include "app/terminal/output.h"
#include "formula/effect_source.h"
#include "foundation/text/shell_word.h"
#include "loading/plugin_catalog.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace lacuna {
namespace {

constexpr std::size_t kLongestName = 100;

/// Of targets: those that CMake makes in every project, and those that Lacuna's package asks for.
constexpr std::array<std::string_view, 15> kTakenTargets = {"all",
                                                            "all_plugins",
                                                            "clean",
                                                            "edit_cache",
                                                            "help",
                                                            "install",
                                                            "lacuna",
                                                            "lacuna_interface",
                                                            "package",
                                                            "package_source",
                                                            "preinstall",
                                                            "program",
                                                            "rebuild_cache",
                                                            "test",
                                                            "lacuna_plugin_headers"};

bool is_plugin_name(const std::string& name) {
  const bool small = std::all_of(name.begin(), name.end(),
                                 [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
  return small && !name.empty() && name.front() >= 'a';
}

/// Formats name their files' ending like themselves.
std::string ending_problem(const NewPlugin& plugin) {
  const bool is_taken = (plugin.kind == "robot format" && plugin.name == "toml") ||
                        (plugin.kind == "recording format" && plugin.name == "csv");
  return is_taken ? "Lacuna reads files that end with ." + plugin.name + " without a plugin; choose another name" : "";
}

/// Where `find_package` finds the package of this program: an installation or a build folder.
std::string prefix_option() {
  std::error_code unknown;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", unknown);
  const std::filesystem::path prefix = program.parent_path().parent_path();
  const bool is_there = !unknown && std::filesystem::exists(prefix / "lib/cmake/lacuna/lacuna-config.cmake", unknown);
  return " -D CMAKE_PREFIX_PATH=" + (is_there ? shell_word(prefix.string()) : "PREFIX");
}

}  // namespace

void check_plugin_name(const NewPlugin& plugin, ProblemList& problems) {
  const auto refuse = [&](const std::string& sentence) { problems.add({plugin.kind, 0, 0}, sentence); };
  const std::string& name = plugin.name;
  if (!is_plugin_name(name))
    return refuse(
        "\"" + name +
        "\" is not a valid plugin name; use lower-case letters, digits and _, a letter first, as in water_drag");
  if (name.size() > kLongestName)
    return refuse(fmt::format("the name has {} letters; at most {} are allowed", name.size(), kLongestName));
  if (std::find(kTakenTargets.begin(), kTakenTargets.end(), name) != kTakenTargets.end())
    refuse(name + " is a CMake target of every project or of Lacuna; choose another name");
  if (const std::string problem = ending_problem(plugin); !problem.empty()) refuse(problem);
  const PluginCatalog catalog(plugin_search_path(plugin.plugin_paths));
  for (const PluginListing& listing : catalog.list())
    if (listing.kind == plugin.kind && listing.name == name)
      refuse(fmt::format("{} {} already exists in {}; choose another name", plugin.kind, name, listing.file.string()));
}

std::filesystem::path write_plugin_folder(const NewPlugin& plugin, const std::map<std::string, std::string>& files) {
  std::filesystem::path folder = (plugin.into / plugin.name).lexically_normal();
  make_output_folder(plugin.into);
  std::error_code error;
  const bool is_new = std::filesystem::create_directory(folder, error);
  if (error && !std::filesystem::exists(folder))
    throw Error(folder.string() + ": cannot be created: " + error.message());
  if (!is_new)
    throw_problem({folder.string(), 0, 0}, "already exists and is not overwritten; choose another name or --into");
  for (const auto& file : files) write_output((folder / file.first).string(), file.second);
  return folder;
}

void print_next_steps(const std::filesystem::path& folder, const std::string& use) {
  const std::string source = shell_word(folder.string()), build = shell_word((folder / "build").string());
  const std::string option = prefix_option();
  fmt::print("then  cmake -S {} -B {}{} && cmake --build {} && ctest --test-dir {}\n", source, build, option, build,
             build);
  const std::string path = "--plugin-path " + shell_word((folder / "build/lib/lacuna/plugins").string());
  fmt::print("      {}\n", filled(use, {{"PATH", path}}));
  if (option.ends_with("=PREFIX"))
    fmt::print("PREFIX is where Lacuna is installed: cmake --install BUILD --prefix PREFIX\n");
}

}  // namespace lacuna
