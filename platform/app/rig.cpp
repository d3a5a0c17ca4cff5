#include "app/rig.h"

#include "app/trial_target.h"
#include "config/experiment_reader.h"
#include "foundation/guarded_call.h"
#include "storage/carried_out.h"
#include "storage/eea_store.h"

#include <algorithm>
#include <mutex>

namespace lacuna {
namespace {

Rig assemble(Experiment experiment, std::shared_ptr<const PluginCatalog> catalog) {
  Rig rig;
  rig.experiment = std::move(experiment);
  rig.catalog = std::move(catalog);
  rig.definition = define_model(rig.experiment, *rig.catalog);
  rig.model = compile(rig.definition.structure, rig.definition.engine);
  const RecordingReader reader(rig.experiment.target.recording, rig.definition.structure.robot,
                               [&rig](const ReadingNote& note) { rig.notes.push_back(note); });
  const std::string& target = rig.experiment.target.kind;
  rig.trials = guarded_call(rig.catalog->origin<TargetSystem>(target), "reading the recorded trials", [&] {
    return rig.catalog->make<TargetSystem>(target)->recorded({.trials = &reader});
  });
  return rig;
}

/// The trials that the database holds of a target that takes tests, those of its last run; what showed how a test
/// transfers was fitted by no model, and is held out.
std::vector<Trial> stored_trials(const std::filesystem::path& file, const std::string& experiment) {
  Database database = Database::open_read_only(file);
  std::vector<Trial> trials;
  for (const EeaRunListing& run : eea_runs(database)) {
    if (run.experiment != experiment || run.passes_done == 0) continue;
    std::mutex unused;
    const EeaStore store(database, unused, run.run, {});
    trials = store.trials();
    const std::vector<TargetTrialRow> rows = store.trial_rows();
    for (std::size_t i = 0; i < rows.size(); ++i) trials[i].held_out = rows[i].for_transfer;
  }
  return trials;
}

Rig with_stored_trials(Rig rig, const CommonOptions& options) {
  if (!rig.catalog->make<TargetSystem>(rig.experiment.target.kind)->takes_tests()) return rig;
  const std::filesystem::path file = database_of(options, rig.experiment);
  if (!std::filesystem::exists(file)) return rig;
  rig.trials = stored_trials(file, rig.experiment.name);
  const TrialTarget target(rig.experiment, rig.definition, *rig.catalog, last_replicate(file, rig.experiment.name));
  for (Trial& trial : carried_out_trials(Database::open_read_only(file), rig.experiment.name, target.digest()))
    rig.trials.push_back(std::move(trial));
  return rig;
}

}  // namespace

int last_replicate(const std::filesystem::path& database, const std::string& experiment) {
  int replicate = 1;
  if (!std::filesystem::exists(database)) return replicate;
  for (const EeaRunListing& run : eea_runs(Database::open_read_only(database)))
    if (run.experiment == experiment && run.passes_done > 0) replicate = run.replicate;
  return replicate;
}

std::filesystem::path database_of(const CommonOptions& options, const Experiment& experiment) {
  return options.database.empty() ? std::filesystem::path(experiment.name + ".db") : options.database;
}

std::size_t Rig::count(bool held_out) const {
  return static_cast<std::size_t>(
      std::count_if(trials.begin(), trials.end(), [&](const Trial& trial) { return trial.held_out == held_out; }));
}

std::vector<Trial> Rig::fit_trials() const {
  std::vector<Trial> chosen;
  std::copy_if(trials.begin(), trials.end(), std::back_inserter(chosen),
               [](const Trial& trial) { return !trial.held_out; });
  return chosen;
}

Rig open_rig(const CommonOptions& options) {
  auto catalog = std::make_shared<const PluginCatalog>(plugin_search_path(options.plugin_paths));
  return with_stored_trials(assemble(read_experiment(options.experiment, options.overrides), std::move(catalog)),
                            options);
}

Rig open_rig(const CommonOptions& options, const std::string& text, std::shared_ptr<const PluginCatalog> catalog) {
  return with_stored_trials(
      assemble(read_experiment_text(text, options.experiment, options.overrides), std::move(catalog)), options);
}

}  // namespace lacuna
