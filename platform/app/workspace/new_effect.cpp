#include "app/workspace/new_effect.h"

#include "app/terminal/options.h"
#include "app/terminal/output.h"
#include "formula/effect_source.h"
#include "foundation/placement_unit.h"
#include "foundation/problem.h"
#include "foundation/shell_word.h"
#include "loading/plugin_catalog.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>

namespace lacuna {
namespace {

constexpr const char* kExample = "-0.01*v*abs(v)";

struct NewEffectOptions {
  CommonOptions common;
  std::string name;
  std::string formula = kExample;
  std::vector<std::string> values;  ///< "b=0.02"
  std::filesystem::path into = ".";
};

void check_name(const NewEffectOptions& options, ProblemList& problems) {
  const std::string& name = options.name;
  const bool small = std::all_of(name.begin(), name.end(),
                                 [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
  if (!small || name.empty() || name.front() < 'a') {
    problems.add({"effect", 0, 0}, "\"" + name +
                                       "\" is no name of a plugin; write small letters, digits and _, a letter "
                                       "first, as in water_drag");
    return;
  }
  for (const char* target : {"all", "clean", "help", "install", "package", "test"})
    if (name == target)
      problems.add({"effect", 0, 0}, name + " is a target of every CMake project; choose another name");
  const PluginCatalog catalog(plugin_search_path(options.common.plugin_paths));
  for (const PluginListing& listing : catalog.list())
    if (listing.kind == "effect" && listing.name == name)
      problems.add({"effect", 0, 0},
                   "there is an effect " + name + " in " + listing.file.string() + " already; choose another name");
}

std::map<std::string, double> read_values(const std::vector<std::string>& words, ProblemList& problems) {
  std::map<std::string, double> values;
  for (const std::string& word : words) {
    const std::size_t equals = word.find('=');
    double value = 0.0;
    const char* begin = word.data() + (equals == word.npos ? 0 : equals + 1);
    const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
    if (equals == word.npos || equals == 0 || error != std::errc{} || end != word.data() + word.size())
      problems.add({"--value", 0, 0}, "\"" + word + "\" is not NAME=NUMBER, as in b=0.02 (in SI units)");
    else if (!values.emplace(word.substr(0, equals), value).second)
      problems.add({"--value", 0, 0}, word.substr(0, equals) + " is given twice; keep one");
  }
  return values;
}

/// Reads the formula unless the command line is faulty already; tells both kinds of problems at once.
ForceLaw read_law(const NewEffectOptions& options) {
  ProblemList problems;
  check_name(options, problems);
  const std::map<std::string, double> values = read_values(options.values, problems);
  ForceLaw law;
  try {
    law = read_force_law(options.formula, values);
  } catch (const BadInput& error) {
    for (const Problem& problem : error.problems()) problems.add(problem);
  }
  problems.throw_if_any();
  return law;
}

/// Makes the folder, which must not exist: nothing of a user's is overwritten.
std::filesystem::path make_folder(const NewEffectOptions& options) {
  std::filesystem::path folder = (options.into / options.name).lexically_normal();
  make_output_folder(options.into);
  std::error_code error;
  if (std::filesystem::create_directory(folder, error)) return folder;
  if (error) throw Error(folder.string() + ": cannot be made: " + error.message());
  throw_problem({folder.string(), 0, 0}, "is there already and is not overwritten; choose another name or --into");
}

void print_law(const std::string& folder, const ForceLaw& law) {
  fmt::print("{} written: tau = {}\n", folder, law.text);
  std::size_t name = 0, unit = 0;
  for (const LawParameter& p : law.parameters) {
    name = std::max(name, p.name.size());
    unit = std::max(unit, unit_in_words(p.unit).size());
  }
  for (const LawParameter& p : law.parameters)
    fmt::print("  {:<{}}  {:<10g}  {:<{}}  within {:g} to {:g}\n", p.name, name, p.start, unit_in_words(p.unit), unit,
               p.lower, p.upper);
  for (const std::string& note : law.notes) fmt::print("note: {}\n", note);
}

/// Where `find_package` finds the package of this program, if it is installed.
std::string prefix_option() {
  std::error_code unknown;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", unknown);
  const std::filesystem::path prefix = program.parent_path().parent_path();
  const bool installed = !unknown && std::filesystem::exists(prefix / "lib/cmake/lacuna/lacuna-config.cmake", unknown);
  return " -D CMAKE_PREFIX_PATH=" + (installed ? shell_word(prefix.string()) : "PREFIX");
}

void print_next(const std::filesystem::path& folder, const NewEffectOptions& options, const ForceLaw& law) {
  const std::string source = shell_word(folder.string()), build = shell_word((folder / "build").string());
  const std::string option = prefix_option();
  fmt::print("then  cmake -S {} -B {}{} && cmake --build {}\n", source, build, option, build);
  fmt::print("      lacuna add EXPERIMENT {} --where {} --plugin-path {}\n", options.name,
             law.uses_command ? "actuator.NAME" : "joint.NAME",
             shell_word((folder / "build/lib/lacuna/plugins").string()));
  if (option.ends_with("=PREFIX"))
    fmt::print("PREFIX is where Lacuna is installed: cmake --install BUILD --prefix PREFIX\n");
}

void make_effect(const NewEffectOptions& options) {
  const ForceLaw law = read_law(options);
  const std::filesystem::path folder = make_folder(options);
  write_output((folder / "CMakeLists.txt").string(), effect_project(options.name));
  write_output((folder / (options.name + ".cpp")).string(), effect_source(options.name, law));
  write_output((folder / "README.md").string(), effect_readme(options.name, law));
  print_law(folder.string(), law);
  print_next(folder, options, law);
}

}  // namespace

void add_new_effect_command(CLI::App& plugins) {
  CLI::App* made = plugins.add_subcommand("new", "Write the source of a plugin");
  made->require_subcommand(1);
  auto options = std::make_shared<NewEffectOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* effect = made->add_subcommand("effect", "Write an effect that is a force law on joints, from a formula");
  effect->add_option("name", options->name, "Name of the effect and of its folder, such as water_drag")
      ->required()
      ->option_text("NAME");
  effect
      ->add_option("--formula", options->formula,
                   std::string("Force in q, v and u (docs/reference/formulas.md); default: ") + kExample)
      ->option_text("TEXT");
  effect
      ->add_option("--value", options->values,
                   "Value of a parameter that the formula names, in SI units: b=0.02; may be repeated")
      ->allow_extra_args(false)
      ->option_text("NAME=NUMBER");
  effect->add_option("--into", options->into, "Folder for the plugin's folder (default: this one)")
      ->option_text("FOLDER");
  add_plugin_path_option(*effect, options->common);
  effect->callback([options] { make_effect(*options); });
}

}  // namespace lacuna
