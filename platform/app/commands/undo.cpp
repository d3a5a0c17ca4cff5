#include "app/commands/commands.h"
#include "app/terminal/options.h"
#include "app/terminal/output.h"
#include "app/terminal/replace_file.h"
#include "app/terminal/text_diff.h"
#include "app/workspace/experiment_workflow.h"
#include "config/edits/effects_editor.h"
#include "config/edits/free_editor.h"
#include "report/text/change_text.h"
#include "report/text/error_text.h"
#include "report/text/times_floor_text.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace lacuna {
namespace {

/// Ids of the effects that `now` has and `then` has not.
std::vector<std::string> added_ids(const EffectList& now, const EffectList& then) {
  std::vector<std::string> ids;
  for (const EffectEntry& entry : now)
    if (std::none_of(then.begin(), then.end(), [&](const EffectEntry& old) { return old.id == entry.id; }))
      ids.push_back(entry.id);
  return ids;
}

/// Values of the robot that the file frees now by their own addresses, and that were fixed then.
std::vector<std::string> freed_values(const std::vector<FreeRange>& now, const std::vector<FreeValueRecord>& then) {
  std::vector<std::string> addresses;
  for (const FreeRange& range : now)
    if (range.pattern.find('*') == std::string::npos &&
        std::none_of(then.begin(), then.end(),
                     [&](const FreeValueRecord& old) { return old.address == range.pattern; }))
      addresses.push_back(range.pattern);
  return addresses;
}

/// What the step from the parent revision to this one added: ids of effects, addresses of values.
struct Added {
  std::vector<std::string> effects, values;
};

/// To be taken back.
Added to_take_back(ExperimentWorkflow& workflow, const CommonOptions& options) {
  const StoredRevision& revision = workflow.revision();
  if (!revision.parent)
    throw Error(fmt::format("{}: revision {} is the first in {}; there is nothing to undo", options.experiment.string(),
                            revision.number, workflow.recorder().file().string()));
  const ResultStore& store = workflow.recorder().store();
  const RevisionRecord parent =
      store.revision_record(store.revision(workflow.recorder().experiment(), *revision.parent)->id);
  const ModelSection& model = workflow.opened().experiment.model;
  Added added{added_ids(model.effects, parent.effects), freed_values(model.free, parent.free)};
  if (added.effects.empty() && added.values.empty())
    throw Error(
        fmt::format("{}: the step from revision {} to {} added no effect and freed no value; undo reverses nothing "
                    "else, so edit the file by hand",
                    options.experiment.string(), *revision.parent, revision.number));
  return added;
}

void run_undo(const CommonOptions& options) {
  check_output(options.json);
  check_replaceable(options.experiment);
  const std::string text = read_text(options.experiment);
  OpenExperiment now = open_experiment(options);
  const std::shared_ptr<const PluginCatalog> catalog = now.catalog;
  ExperimentWorkflow workflow(options, std::move(now));
  std::string edited = text;
  const Added added = to_take_back(workflow, options);
  for (const std::string& id : added.effects) edited = remove_effect(edited, id);
  for (const std::string& address : added.values) edited = remove_free_value(edited, address);
  OpenExperiment before = open_experiment(options, edited, catalog);
  workflow.recorder().done();

  const RevisionErrors errors = errors_with_edit(options, std::move(before), text, edited);
  if (!takes_standard_output(options.json)) {
    fmt::print("{}\n{}", options.experiment.string(), text_diff(text, edited));
    fmt::print("back at revision {}\n", errors.revision);
    for (const PooledScore& score : errors.comparison.pooled)
      fmt::print("{} {}: {} × floor on the fit files\n", score.channel, error_text(score),
                 times_floor_text(score.times_floor));
  }
  if (options.json) write_output(*options.json, change_json("undo", errors, errors));
}

}  // namespace

void add_undo_command(CLI::App& program) {
  auto options = std::make_shared<CommonOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand(
      "undo", "Undo the last add: remove the effect, or no longer fit a value of the robot file that it made free");
  add_experiment_options(*command, *options);
  add_work_options(*command, *options);
  command->callback([options] { run_undo(*options); });
}

}  // namespace lacuna
