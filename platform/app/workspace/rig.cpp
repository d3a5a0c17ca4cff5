#include "app/workspace/rig.h"

#include "app/terminal/output.h"
#include "app/workspace/controller_notes.h"
#include "app/workspace/note_sentences.h"
#include "app/workspace/shared_database.h"
#include "app/workspace/trial_target.h"
#include "config/decided.h"
#include "config/experiment_reader.h"
#include "config/result_setting.h"
#include "evaluation/recording_files.h"
#include "evaluation/robots/robot_files.h"
#include "evaluation/prediction/step_count.h"
#include "foundation/text/counted.h"
#include "foundation/processes/guarded_call.h"
#include "foundation/recording_folder.h"
#include "storage/eea/eea_store.h"
#include "storage/results/carried_out.h"
#include "storage/results/stored_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <mutex>

namespace lacuna {
namespace {

void note_inputs(const Experiment& experiment, const CommonOptions& options) {
  refuse_outputs_among(input_files(experiment));
  note_database(database_of(options, experiment));
}

/// With its plugins and its model.
Rig define(Experiment experiment, std::shared_ptr<const PluginCatalog> catalog) {
  Rig rig;
  rig.experiment = std::move(experiment);
  rig.catalog = std::move(catalog);
  for (RobotFileNote& note : read_robot_files(rig.experiment, *rig.catalog))
    rig.notes.push_back({note.location, std::move(note.text)});
  rig.definition = define_model(rig.experiment, *rig.catalog);
  return rig;
}

void compile_model(Rig& rig) {
  decide_engine(rig.experiment, rig.definition.engine.engine);
  rig.model = compile(rig.definition.structure, rig.definition.engine);  // delays are kept by the step
}

/// Throws `BadInput` where no plugin is the target that the experiment names.
void check_target(const Rig& rig) {
  const std::string& kind = rig.experiment.target.kind;
  try {
    rig.catalog->make<TargetSystem>(kind);
  } catch (const ComponentError&) {
    throw;
  } catch (const Error& error) {
    throw_problem(rig.experiment.where("target.kind"), std::string("target.kind: ") + error.what());
  }
}

Rig assemble(Experiment experiment, std::shared_ptr<const PluginCatalog> catalog) {
  Rig rig = define(std::move(experiment), std::move(catalog));
  const std::string& target = rig.experiment.target.kind;
  check_target(rig);
  check_step_count(rig.experiment, {}, rig.catalog->make<TargetSystem>(target)->takes_tests());
  const PluginRecordingFormats formats(*rig.catalog);
  const RecordingReader reader(
      rig.experiment.target.recording, rig.definition.structure.robot,
      [&rig](const ReadingNote& note) { rig.notes.push_back(note); }, &formats);
  rig.trials = guarded_call(rig.catalog->origin<TargetSystem>(target), "reading the recorded trials",
                            [&] { return rig.catalog->make<TargetSystem>(target)->recorded({.trials = &reader}); });
  for (ReadingNote& note : controller_notes(rig.experiment, rig.trials)) rig.notes.push_back(std::move(note));
  check_step_count(rig.experiment, rig.trials, false);
  compile_model(rig);
  return rig;
}

/// Trials of one run of the algorithm; no model was fitted to transfer trials, so they are held out.
std::vector<Trial> trials_of(Database& database, RunId run) {
  std::mutex unused;
  const EeaStore store(database, unused, run, {});
  std::vector<Trial> trials = store.trials();
  const std::vector<TargetTrialRow> rows = store.trial_rows();
  for (std::size_t i = 0; i < rows.size(); ++i) trials[i].held_out = rows[i].for_transfer;
  return trials;
}

/// Adds the trials of the last run on this target; how many a later one on another target has.
std::size_t add_trials_of_run(Database& database, Rig& rig) {
  const TomlNode now = result_setting(rig.experiment.text, rig.experiment.overrides);
  std::vector<EeaRunListing> runs = eea_runs(database);
  std::reverse(runs.begin(), runs.end());
  std::size_t others = 0;
  for (const EeaRunListing& run : runs) {
    if (run.experiment != rig.experiment.name || run.passes_done == 0) continue;
    const ExperimentRecord then = stored_run(database, run.run).experiment;
    std::vector<Trial> trials = trials_of(database, run.run);
    if (same_target(result_setting(then.text, then.overrides), now)) {
      rig.trials = std::move(trials);
      break;
    }
    if (others == 0) others = trials.size();
  }
  return others;
}

/// Adds the trials that were carried out one by one on this target; how many there are of others.
std::size_t add_single_trials(const Database& database, const std::string& target, Rig& rig) {
  std::vector<Trial> trials = carried_out_trials(database, rig.experiment.name, target);
  const auto all = static_cast<std::size_t>(count_carried_out(database, rig.experiment.name));
  const std::size_t others = all - trials.size();
  std::move(trials.begin(), trials.end(), std::back_inserter(rig.trials));
  return others;
}

/// The trials and the warnings that its database has for it.
Rig with_database(Rig rig, const CommonOptions& options) {
  if (auto note = shared_database_note(rig.experiment, database_of(options, rig.experiment)))
    rig.notes.push_back(std::move(*note));
  const std::string& kind = rig.experiment.target.kind;
  if (!rig.catalog->make<TargetSystem>(kind)->takes_tests()) return rig;
  const std::filesystem::path file = database_of(options, rig.experiment);
  if (!std::filesystem::exists(file)) return rig;
  Database database = Database::open_read_only(file);
  const TrialTarget target(rig.experiment, rig.definition, *rig.catalog, last_replicate(file, rig.experiment.name));
  std::size_t others = add_trials_of_run(database, rig);
  others += add_single_trials(database, target.digest(), rig);
  if (others > 0)
    rig.left_out = fmt::format("{} in {} {} from another {} and left out", counted(others, "trial"), file.string(),
                               others == 1 ? "is" : "are", kind == "process" ? "target.version" : "target");
  return rig;
}

}  // namespace

std::vector<std::filesystem::path> input_files(const Experiment& experiment) {
  std::vector<std::filesystem::path> files = {experiment.file, experiment.model.file,
                                              experiment.target.simulated.system.file};
  const auto add = [&files](const std::filesystem::path& path) {
    files.push_back(is_recording_folder(path) ? path / "metadata.yaml" : path);
    if (!is_recording_folder(path)) return;
    for (const std::filesystem::path& part : files_of_recording(path)) files.push_back(part);
  };
  for (const MeasuredFile& file : experiment.target.recording.files) {
    add(file.path);
    for (const FurtherFile& further : file.with) add(further.path);
  }
  for (const ModelSection* section : {&experiment.model, &experiment.target.simulated.system})
    files.insert(files.end(), section->parts.begin(), section->parts.end());
  std::erase(files, std::filesystem::path());
  return files;
}

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

void Rig::tell_doubts() const {
  std::vector<ReadingNote> doubts;
  std::ranges::copy_if(notes, std::back_inserter(doubts), &ReadingNote::doubt);
  for (const std::string& sentence : note_sentences(doubts)) fmt::print(stderr, "{}\n", sentence);
}

Rig open_rig(const CommonOptions& options) {
  Experiment experiment = read_experiment(options.experiment, options.overrides);
  note_inputs(experiment, options);
  auto catalog = std::make_shared<const PluginCatalog>(plugin_search_path(options.plugin_paths));
  return with_database(assemble(std::move(experiment), std::move(catalog)), options);
}

Rig open_rig(const CommonOptions& options, const std::string& text, std::shared_ptr<const PluginCatalog> catalog) {
  Experiment experiment = read_experiment_text(text, options.experiment, options.overrides);
  decide_as(experiment, options.decided);
  note_inputs(experiment, options);
  return with_database(assemble(std::move(experiment), std::move(catalog)), options);
}

Rig open_rig_without_trials(const CommonOptions& options, const std::string& text) {
  Experiment experiment = read_experiment_text(text, options.experiment, options.overrides);
  decide_as(experiment, options.decided);
  Rig rig =
      define(std::move(experiment), std::make_shared<const PluginCatalog>(plugin_search_path(options.plugin_paths)));
  compile_model(rig);
  return rig;
}

}  // namespace lacuna
