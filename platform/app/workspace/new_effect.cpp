#include "app/workspace/new_effect.h"

#include "app/terminal/options.h"
#include "app/workspace/plugin_folder.h"
#include "formula/effect_source.h"
#include "foundation/placement_unit.h"
#include "foundation/text/problem.h"

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

  NewPlugin plugin() const { return {"effect", name, into, common.plugin_paths}; }
};

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
  check_plugin_name(options.plugin(), problems);
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

void print_law(const std::string& folder, const ForceLaw& law) {
  fmt::print("{} written: tau = {}\n", folder, law.text);
  std::size_t name = 0, unit = 0;
  for (const LawParameter& p : law.parameters) {
    name = std::max(name, p.name.size());
    unit = std::max(unit, unit_in_words(p.unit).size());
  }
  for (const LawParameter& p : law.parameters)
    fmt::print("  {:<{}}  {:<10g}  {:<{}}  within {:g} to {:g}\n", p.name, name, p.default_value, unit_in_words(p.unit),
               unit, p.lower, p.upper);
  for (const std::string& note : law.notes) fmt::print("note: {}\n", note);
}

void make_effect(const NewEffectOptions& options) {
  const ForceLaw law = read_law(options);
  const std::string& name = options.name;
  const std::filesystem::path folder = write_plugin_folder(options.plugin(), {{"CMakeLists.txt", effect_project(name)},
                                                                              {name + ".cpp", effect_source(name, law)},
                                                                              {"README.md", effect_readme(name, law)}});
  print_law(folder.string(), law);
  print_next_steps(folder, fmt::format("lacuna add EXPERIMENT {} --where {} @PATH@", name,
                                       law.uses_command ? "actuator.NAME" : "joint.NAME"));
}

}  // namespace

void add_new_effect_command(CLI::App& made) {
  auto options = std::make_shared<NewEffectOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* effect = made.add_subcommand("effect", "Write an effect from a formula: a force law on joints");
  effect->add_option("name", options->name, "Name of the effect and of its folder, such as water_drag")
      ->required()
      ->option_text("NAME");
  effect
      ->add_option("--formula", options->formula,
                   std::string("Formula of the force in q, v and u (docs/reference/formulas.md); default: ") + kExample)
      ->option_text("TEXT");
  effect
      ->add_option("--value", options->values,
                   "Value of a parameter in the formula, in SI units: b=0.02; may be repeated")
      ->allow_extra_args(false)
      ->option_text("NAME=NUMBER");
  effect
      ->add_option("--into", options->into, "Folder in which the plugin's folder is made (default: the current folder)")
      ->option_text("FOLDER");
  add_plugin_path_option(*effect, options->common);
  effect->callback([options] { make_effect(*options); });
}

}  // namespace lacuna
