#include "app/commands/commands.h"
#include "app/terminal/options.h"
#include "app/terminal/output.h"
#include "app/terminal/replace_file.h"
#include "app/terminal/text_diff.h"
#include "app/terminal/time_limit.h"
#include "app/workspace/default_place.h"
#include "app/workspace/asked_value.h"
#include "app/workspace/diagnosed_start.h"
#include "app/workspace/integration.h"
#include "app/workspace/search_range.h"
#include "app/workspace/experiment_workflow.h"
#include "candidates/wrong_value.h"
#include "config/edits/effects_editor.h"
#include "config/edits/free_editor.h"
#include "config/schema/value.h"
#include "evaluation/model/redundant_effect.h"
#include "foundation/address.h"
#include "foundation/text/problem.h"
#include "foundation/text/shell_word.h"
#include "foundation/text/counted.h"
#include "report/text/change_text.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

namespace lacuna {
namespace {

struct AddOptions : CommonOptions {
  std::string effect;
  std::vector<std::string> where;
  std::string id;
  std::vector<std::string> start;  ///< name=value
  std::vector<std::string> fixed;
  bool answer = false;  ///< add what the latest diagnosis found
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
    if (used == number.size() && std::isfinite(value)) return {text.substr(0, equals), value};
  } catch (const std::exception&) {
    // said below
  }
  throw_problem({}, "--start " + text + ": write PARAMETER=NUMBER in SI units, as in --start torque=0.1");
}

/// Problems that the editor of the list would report later and less clearly.
void check_id(const std::string& id, const EffectList& effects) {
  if (!id.empty() && !is_element_name(id))
    throw_problem({}, "--id " + id + ": is not a valid id; use letters, digits, _ and -");
  for (const EffectEntry& entry : effects)
    if (entry.id == id)
      throw_problem(
          {}, "--id " + id + ": is taken by " + with_article(entry.effect) + " of the model; choose another name");
}

/// What the option was that became a key of the effect's entry, as it was typed.
std::string typed(const std::string& key, const AddOptions& options) {
  const auto element = [&](const std::string& option, const std::vector<std::string>& list) {
    const std::size_t index = std::stoul(key.substr(key.find('[') + 1));
    return option + (index < list.size() ? " " + list[index] : "");
  };
  if (key.starts_with("where[")) return element("--where", options.where);
  if (key.starts_with("fixed[")) return element("--fixed", options.fixed);
  if (key.starts_with("start.")) return "--start " + key.substr(6);
  if (key == "where") return "--where";
  return key == "id" ? "--id" : options.effect;
}

/// The experiment with the effect in it. Problems of the effect alone name the command's arguments, because its entry
/// is in no file yet.
OpenExperiment open_extended(const AddOptions& options, const std::string& edited, const OpenExperiment& base) {
  try {
    return open_experiment(options, edited, base.catalog);
  } catch (const BadInput& bad) {
    const std::string entry = fmt::format("model.effects[{}]", base.experiment.model.effects.size());
    ProblemList problems;
    for (const Problem& problem : bad.problems()) {
      if (!problem.key.starts_with(entry)) {
        problems.add(problem);
        continue;
      }
      const std::string key = problem.key.substr(std::min(problem.key.size(), entry.size() + 1));
      problems.add({}, "add " + typed(key, options) + problem.message.substr(problem.key.size()));
    }
    problems.throw_if_any();
    throw;
  }
}

/// The element that both entries act on, "the world" where they name none; nothing if they have none in common.
std::optional<std::string> shared_place(const EffectEntry& a, const EffectEntry& b) {
  if (a.where.empty() && b.where.empty()) return "the world";
  for (const std::string& element : a.where)
    if (std::find(b.where.begin(), b.where.end(), element) != b.where.end()) return element;
  return std::nullopt;
}

/// A second effect of the same kind in the same place is usually a repeated command; an explicit id allows it.
void check_new(const AddOptions& options, const std::string& id, const EffectList& placed) {
  if (!options.id.empty()) return;
  const auto added = std::find_if(placed.begin(), placed.end(), [&](const auto& entry) { return entry.id == id; });
  for (const EffectEntry& entry : placed) {
    if (entry.id == id || entry.effect != options.effect) continue;
    const std::optional<std::string> place = shared_place(entry, *added);
    if (!place) continue;
    throw_problem({}, fmt::format("{}: {} has this effect already (id {}); of two such effects, data show only the "
                                  "sum. To add a second one, give it an id: --id {}",
                                  options.effect, *place, entry.id, id));
  }
}

EffectEntry entry_of(const AddOptions& options, const OpenExperiment& before) {
  std::map<std::string, double> starts;
  for (const std::string& start : options.start) starts.insert(parse_start(start));
  if (options.effect == kWrongValue)
    return asked_value(options.where, options.id, options.fixed, starts, before.definition);
  const EffectList& effects = before.experiment.model.effects;
  EffectEntry entry{options.id.empty() ? free_id(options.effect, effects) : options.id, options.effect, options.where,
                    std::move(starts), options.fixed};
  return entry;
}

/// The text with the effect in its list, or with the value among the free ones.
std::string with_addition(const std::string& text, const EffectEntry& entry) {
  return is_wrong_value(entry) ? insert_free_value(text, free_range(entry)) : insert_effect(text, entry);
}

bool evolves_models(const OpenExperiment& opened) {
  return opened.catalog->make<TargetSystem>(opened.experiment.target.kind)->takes_tests();
}

struct Addition {
  EffectEntry entry;
  bool from_diagnosis = false;  ///< the start values that were not typed
  bool only_place = false;      ///< the place was not typed, and no other is possible
};

/// The experiment before and after; everything is checked before the file is touched.
struct Extension {
  std::string text, edited;
  std::vector<Addition> added;
  OpenExperiment base, extended;
};

/// Values of an effect that a diagnosis held, since they act only together with one that it found, stay where they are.
void hold_others(const std::map<std::string, double>& found, const OpenExperiment& extended, EffectEntry& entry) {
  const std::size_t name_begins = effect_address(entry.id, "").size();
  for (const FreeValue& free : extended.definition.free) {
    if (!is_of_effect(free.address, entry.id)) continue;
    const std::string name = free.address.substr(name_begins);
    if (!found.contains(name) && !entry.start.contains(name)) entry.fixed.push_back(name);
  }
}

/// The rig with one more effect, which is put into `edited`, the text that `before` was read from. `base`: without any
/// of those that are added.
OpenExperiment extend(AddOptions one, const OpenExperiment& base, const OpenExperiment& before, std::string& edited,
                      std::vector<Addition>& added) {
  const bool says_where = !one.where.empty();
  if (!says_where && one.effect != kWrongValue) one.where = default_place(before, one.effect);
  check_id(one.id, before.experiment.model.effects);
  EffectEntry entry = entry_of(one, before);
  const std::string text = edited;
  edited = with_addition(text, entry);
  OpenExperiment extended = open_extended(one, edited, before);
  if (!is_wrong_value(entry)) check_new(one, entry.id, extended.definition.effects);
  std::map<std::string, double> found = diagnosed_start(one, base, extended, entry);
  if (!found.empty()) hold_others(found, extended, entry);
  for (const auto& [name, value] : entry.start) found[name] = value;
  const bool from_diagnosis = found.size() > entry.start.size();
  entry.start = std::move(found);
  if (evolves_models(base) && !is_wrong_value(entry)) entry.range = search_range(entry, extended.definition);
  if (from_diagnosis || !entry.range.empty()) {
    edited = with_addition(text, entry);
    extended = open_extended(one, edited, before);
  }
  added.push_back({std::move(entry), from_diagnosis, !says_where && !one.where.empty()});
  return extended;
}

/// The effect that was typed, or those of the diagnosed answer: a command each.
std::vector<AddOptions> asked_for(const AddOptions& options, const OpenExperiment& base) {
  if (!options.answer) return {options};
  std::vector<AddOptions> all;
  for (const auto& [effect, place] : diagnosed_answer(options, base)) {
    AddOptions one = options;
    one.effect = effect;
    if (place != "world") one.where = {place};
    all.push_back(std::move(one));
  }
  if (all.empty())
    throw_problem({}, fmt::format("--answer: no diagnosis of this model has found an effect; run: {}",
                                  command_to_type("diagnose", options)));
  return all;
}

Extension extension_of(const AddOptions& options) {
  const std::string text = read_text(options.experiment);
  OpenExperiment base = open_experiment(options);
  settle_substeps(base, base.fit_trials(), options.work());
  std::string edited = text;
  std::vector<Addition> added;
  std::optional<OpenExperiment> extended;
  for (const AddOptions& one : asked_for(options, base))
    extended = extend(one, base, extended ? *extended : base, edited, added);
  return {text, std::move(edited), std::move(added), std::move(base), std::move(*extended)};
}

void check_request(const AddOptions& options) {
  if (!options.answer && options.effect.empty())
    throw_problem({}, "add: name the effect, or write --answer to add what the last diagnosis found");
  const bool says_more = !options.effect.empty() || !options.where.empty() || !options.id.empty() ||
                         !options.start.empty() || !options.fixed.empty();
  if (options.answer && says_more)
    throw_problem({},
                  "add --answer takes effects, places and values from the diagnosis; leave out the effect, --where, "
                  "--id, --start and --fixed");
}

void run_add(const AddOptions& options) {
  check_request(options);
  check_output(options.json);
  check_replaceable(options.experiment);
  Extension made = extension_of(options);
  std::vector<std::string> ids, redundancies;
  for (const Addition& addition : made.added) {
    ids.push_back(addition.entry.id);
    if (is_wrong_value(addition.entry)) continue;
    if (std::string text = redundancy_of(made.extended.definition, addition.entry.id); !text.empty())
      redundancies.push_back(std::move(text));
  }
  const RevisionErrors before = errors_before_edit(options, std::move(made.base));
  const RevisionErrors after = errors_with_edit(options, std::move(made.extended), made.text, made.edited);
  if (!takes_standard_output(options.json)) {
    fmt::print("{}\n{}", options.experiment.string(), text_diff(made.text, made.edited));
    for (const Addition& addition : made.added) {
      const EffectEntry& entry = addition.entry;
      if (addition.only_place)
        fmt::print("{} is placed on {}, the only possible place\n", entry.id, entry.where.front());
      if (addition.from_diagnosis) fmt::print("{} starts at the values that the diagnosis found\n", entry.id);
    }
    fmt::print("{}", change_text(before, after, command_to_type("undo", options)));
    for (const std::string& redundancy : redundancies) fmt::print("{}\n", redundancy);
    fmt::print("undo: {}\n→ {}\n", command_to_type("undo", options), command_to_type("compare", options));
  }
  if (options.json)
    write_output(*options.json, change_json(fmt::format("{}", fmt::join(ids, " + ")), before, after,
                                            command_to_type("undo", options)));
}

}  // namespace

void add_add_command(CLI::App& program) {
  auto options = std::make_shared<AddOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("add", "Add a physical effect to the model, then fit the model again");
  add_experiment_options(*command, *options);
  command
      ->add_option("effect", options->effect,
                   "Name of the effect (see lacuna plugins list). To fit a fixed value of the "
                   "robot file instead, write wrong_value and name the value with --where")
      ->option_text("NAME");
  command->add_flag("--answer", options->answer, "Add the effects that the last diagnosis of this model found");
  command
      ->add_option("--where", options->where,
                   "Element to place the effect on, such as joint.hinge; for wrong_value the address, such as "
                   "joint.hinge.armature; may be repeated (default: the only possible element)")
      ->allow_extra_args(false)
      ->option_text("ELEMENT");
  command->add_option("--id", options->id, "Id of the effect in the model (default: the effect's name)")
      ->option_text("NAME");
  command->add_option("--start", options->start, "Start value of a parameter, in SI units: torque=0.1; may be repeated")
      ->allow_extra_args(false)
      ->option_text("PARAMETER=NUMBER");
  command->add_option("--fixed", options->fixed, "Parameter that is not fitted; may be repeated")
      ->allow_extra_args(false)
      ->option_text("PARAMETER");
  add_work_options(*command, *options);
  add_time_limit_option(*command, *options);
  command->callback([options] { run_add(*options); });
}

}  // namespace lacuna
