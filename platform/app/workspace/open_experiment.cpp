#include "app/workspace/open_experiment.h"

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
OpenExperiment define(Experiment experiment, std::shared_ptr<const PluginCatalog> catalog, const Stop& stop) {
  OpenExperiment opened;
  opened.stop = stop;
  opened.experiment = std::move(experiment);
  opened.catalog = std::move(catalog);
  for (RobotFileNote& note : read_robot_files(opened.experiment, *opened.catalog))
    opened.notes.push_back({note.location, std::move(note.text)});
  opened.definition = define_model(opened.experiment, *opened.catalog);
  return opened;
}

void compile_model(OpenExperiment& opened) {
  decide_engine(opened.experiment, opened.definition.engine.engine);
  opened.model = compile(opened.definition.structure, opened.definition.engine);  // delays are kept by the step
}

/// Throws `BadInput` where no plugin is the target that the experiment names.
void check_target(const OpenExperiment& opened) {
  const std::string& kind = opened.experiment.target.kind;
  try {
    opened.catalog->make<TargetSystem>(kind);
  } catch (const ComponentError&) {
    throw;
  } catch (const Error& error) {
    throw_problem(opened.experiment.where("target.kind"), std::string("target.kind: ") + error.what());
  }
}

OpenExperiment assemble(Experiment experiment, std::shared_ptr<const PluginCatalog> catalog, const Stop& stop) {
  OpenExperiment opened = define(std::move(experiment), std::move(catalog), stop);
  const std::string& target = opened.experiment.target.kind;
  check_target(opened);
  check_step_count(opened.experiment, {}, opened.catalog->make<TargetSystem>(target)->takes_tests());
  const PluginRecordingFormats formats(*opened.catalog);
  const RecordingReader reader(
      opened.experiment.target.recording, opened.definition.structure.robot,
      [&opened](const ReadingNote& note) { opened.notes.push_back(note); }, &formats, stop);
  opened.trials = guarded_call(opened.catalog->origin<TargetSystem>(target), "reading the recorded trials", [&] {
    return opened.catalog->make<TargetSystem>(target)->recorded({.trials = &reader});
  });
  for (ReadingNote& note : controller_notes(opened.experiment, opened.trials)) opened.notes.push_back(std::move(note));
  check_step_count(opened.experiment, opened.trials, false);
  compile_model(opened);
  return opened;
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
std::size_t add_trials_of_run(Database& database, OpenExperiment& opened) {
  const TomlNode now = result_setting(opened.experiment.text, opened.experiment.overrides);
  std::vector<EeaRunListing> runs = eea_runs(database);
  std::reverse(runs.begin(), runs.end());
  std::size_t others = 0;
  for (const EeaRunListing& run : runs) {
    if (run.experiment != opened.experiment.name || run.passes_done == 0) continue;
    const ExperimentRecord then = stored_run(database, run.run).experiment;
    std::vector<Trial> trials = trials_of(database, run.run);
    if (same_target(result_setting(then.text, then.overrides), now)) {
      opened.trials = std::move(trials);
      break;
    }
    if (others == 0) others = trials.size();
  }
  return others;
}

/// Adds the trials that were carried out one by one on this target; how many there are of others.
std::size_t add_single_trials(const Database& database, const std::string& target, OpenExperiment& opened) {
  std::vector<Trial> trials = carried_out_trials(database, opened.experiment.name, target);
  const auto all = static_cast<std::size_t>(count_carried_out(database, opened.experiment.name));
  const std::size_t others = all - trials.size();
  std::move(trials.begin(), trials.end(), std::back_inserter(opened.trials));
  return others;
}

/// The trials and the warnings that its database has for it.
OpenExperiment with_database(OpenExperiment opened, const CommonOptions& options) {
  if (auto note = shared_database_note(opened.experiment, database_of(options, opened.experiment), options.stop))
    opened.notes.push_back(std::move(*note));
  const std::string& kind = opened.experiment.target.kind;
  if (!opened.catalog->make<TargetSystem>(kind)->takes_tests()) return opened;
  const std::filesystem::path file = database_of(options, opened.experiment);
  if (!std::filesystem::exists(file)) return opened;
  Database database = Database::open_read_only(file, options.stop);
  const TrialTarget target(opened.experiment, opened.definition, *opened.catalog,
                           last_replicate(file, opened.experiment.name, options.stop), options.stop);
  std::size_t others = add_trials_of_run(database, opened);
  others += add_single_trials(database, target.digest(), opened);
  if (others > 0)
    opened.left_out = fmt::format("{} in {} {} from another {} and left out", counted(others, "trial"), file.string(),
                                  others == 1 ? "is" : "are", kind == "process" ? "target.version" : "target");
  return opened;
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

int last_replicate(const std::filesystem::path& database, const std::string& experiment, const Stop& stop) {
  int replicate = 1;
  if (!std::filesystem::exists(database)) return replicate;
  for (const EeaRunListing& run : eea_runs(Database::open_read_only(database, stop)))
    if (run.experiment == experiment && run.passes_done > 0) replicate = run.replicate;
  return replicate;
}

std::filesystem::path database_of(const CommonOptions& options, const Experiment& experiment) {
  return options.database.empty() ? std::filesystem::path(experiment.name + ".db") : options.database;
}

std::size_t OpenExperiment::count(bool held_out) const {
  return static_cast<std::size_t>(
      std::count_if(trials.begin(), trials.end(), [&](const Trial& trial) { return trial.held_out == held_out; }));
}

std::vector<Trial> OpenExperiment::fit_trials() const {
  std::vector<Trial> chosen;
  std::copy_if(trials.begin(), trials.end(), std::back_inserter(chosen),
               [](const Trial& trial) { return !trial.held_out; });
  return chosen;
}

void OpenExperiment::tell_doubts() const {
  std::vector<ReadingNote> doubts;
  std::ranges::copy_if(notes, std::back_inserter(doubts), &ReadingNote::doubt);
  for (const std::string& sentence : note_sentences(doubts)) fmt::print(stderr, "{}\n", sentence);
}

OpenExperiment open_experiment(const CommonOptions& options) {
  Experiment experiment = read_experiment(options.experiment, options.overrides);
  note_inputs(experiment, options);
  auto catalog = std::make_shared<const PluginCatalog>(plugin_search_path(options.plugin_paths));
  return with_database(assemble(std::move(experiment), std::move(catalog), options.stop), options);
}

OpenExperiment open_experiment(const CommonOptions& options, const std::string& text,
                               std::shared_ptr<const PluginCatalog> catalog) {
  Experiment experiment = read_experiment_text(text, options.experiment, options.overrides);
  decide_as(experiment, options.decided);
  note_inputs(experiment, options);
  return with_database(assemble(std::move(experiment), std::move(catalog), options.stop), options);
}

OpenExperiment open_experiment_without_trials(const CommonOptions& options, const std::string& text) {
  Experiment experiment = read_experiment_text(text, options.experiment, options.overrides);
  decide_as(experiment, options.decided);
  OpenExperiment opened =
      define(std::move(experiment), std::make_shared<const PluginCatalog>(plugin_search_path(options.plugin_paths)),
             options.stop);
  compile_model(opened);
  return opened;
}

}  // namespace lacuna
