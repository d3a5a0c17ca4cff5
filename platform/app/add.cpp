#include "app/commands.h"
#include "app/options.h"
#include "app/output.h"
#include "app/replace_file.h"
#include "app/text_diff.h"
#include "app/workbench.h"
#include "config/effects_editor.h"
#include "config/value.h"
#include "foundation/problem.h"
#include "report/change_text.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace lacuna {
namespace {

struct AddOptions : CommonOptions {
  std::string effect;
  std::vector<std::string> where;
  std::string id;
  std::vector<std::string> start;  ///< name=value
  std::vector<std::string> fixed;
};

/// The effect's name, or with a number behind it where that id is taken.
std::string free_id(const std::string& effect, const EffectList& effects) {
  const auto taken = [&](const std::string& id) {
    return std::any_of(effects.begin(), effects.end(), [&](const EffectEntry& entry) { return entry.id == id; });
  };
  std::string id = effect;
  for (int number = 2; taken(id); ++number) id = fmt::format("{}_{}", effect, number);
  return id;
}

std::pair<std::string, double> parse_start(const std::string& text) {
  const std::size_t equals = text.find('=');
  try {
    std::size_t used = 0;
    const std::string number = equals == std::string::npos ? "" : text.substr(equals + 1);
    const double value = std::stod(number, &used);
    if (used == number.size()) return {text.substr(0, equals), value};
  } catch (const std::exception&) {
    // said below
  }
  throw_problem({}, "--start " + text + ": write it as parameter=number, in SI units, as in --start torque=0.1");
}

/// Those that the editor of the list would meet later, and say less well.
void check_id(const std::string& id, const EffectList& effects) {
  if (!id.empty() && !is_element_name(id))
    throw_problem({}, "--id " + id + ": cannot be a name; use letters, digits, _ and -");
  for (const EffectEntry& entry : effects)
    if (entry.id == id)
      throw_problem({}, "--id " + id + ": is taken by a " + entry.effect + " of the model; choose another name");
}

EffectEntry entry_of(const AddOptions& options, const EffectList& effects) {
  EffectEntry entry{options.id.empty() ? free_id(options.effect, effects) : options.id,
                    options.effect,
                    options.where,
                    {},
                    options.fixed};
  for (const std::string& start : options.start) entry.start.insert(parse_start(start));
  return entry;
}

void run_add(const AddOptions& options) {
  check_output(options.json);
  check_replaceable(options.experiment);
  const std::string text = read_text(options.experiment);
  Rig base = open_rig(options);
  check_id(options.id, base.experiment.model.effects);
  const EffectEntry entry = entry_of(options, base.experiment.model.effects);
  const std::string edited = insert_effect(text, entry);
  Rig extended = open_rig(options, edited, base.catalog);  // everything is checked before the file is touched

  const RevisionErrors before = errors_before_edit(options, std::move(base));
  const RevisionErrors after = errors_before_edit(options, std::move(extended));
  replace_text(options.experiment, text, edited);
  if (!takes_standard_output(options.json)) {
    fmt::print("{}\n{}", options.experiment.string(), text_diff(text, edited));
    fmt::print("{}", change_text(before, after));
    fmt::print("undo: lacuna undo {0}\n→ lacuna compare {0}\n", options.experiment.string());
  }
  if (options.json) write_output(*options.json, change_json(entry.id, before, after));
}

}  // namespace

void add_add_command(CLI::App& program) {
  auto options = std::make_shared<AddOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("add", "Add a physical effect to the model and fit it again");
  add_experiment_options(*command, *options);
  command->add_option("effect", options->effect, "Name of the effect (see lacuna plugins list)")
      ->required()
      ->option_text("NAME");
  command
      ->add_option("--where", options->where,
                   "Element to place it on, such as joint.hinge; may be repeated; none: the world")
      ->allow_extra_args(false)
      ->option_text("ELEMENT");
  command->add_option("--id", options->id, "Name of this placement (default: the effect's)")->option_text("NAME");
  command->add_option("--start", options->start, "Start value of a parameter, in SI units: torque=0.1; may be repeated")
      ->allow_extra_args(false)
      ->option_text("PARAMETER=NUMBER");
  command->add_option("--fixed", options->fixed, "Parameter that is not fitted; may be repeated")
      ->allow_extra_args(false)
      ->option_text("PARAMETER");
  add_work_options(*command, *options);
  command->callback([options] { run_add(*options); });
}

}  // namespace lacuna
