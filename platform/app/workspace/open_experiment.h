#pragma once

#include <lacuna/trial.h>

#include "app/terminal/options.h"
#include "config/schema/experiment.h"
#include "evaluation/model/model_definition.h"
#include "loading/plugin_catalog.h"
#include "measurement/recording.h"
#include "simulation/compiled_model.h"

#include <memory>
#include <vector>

namespace lacuna {

/// An experiment with everything it names: plugins loaded, trials read, the model compiled.
struct OpenExperiment {
  Experiment experiment;
  std::shared_ptr<const PluginCatalog>
      catalog;  ///< shared: a command that edits the file opens it twice with one catalog
  ModelDefinition definition;
  std::unique_ptr<CompiledModel> model;
  std::vector<Trial> trials;       ///< fit trials first
  std::vector<ReadingNote> notes;  ///< what was noticed while reading the measurements
  Stop stop = {};                  ///< of the command that opened it
  std::string left_out;            ///< trials in the database that are another target's, a sentence; empty: none

  std::size_t count(bool held_out) const;
  /// Without those that are held out.
  std::vector<Trial> fit_trials() const;
  /// Prints the notes that every command repeats to standard error.
  void tell_doubts() const;
};

/// Everything that a command reads of an experiment, except for its database.
std::vector<std::filesystem::path> input_files(const Experiment& experiment);

/// `--db`, or the experiment's name with `.db` in the working folder.
std::filesystem::path database_of(const CommonOptions& options, const Experiment& experiment);

/// The replicate of the last run of the algorithm that the database has of an experiment; 1 without any.
int last_replicate(const std::filesystem::path& database, const std::string& experiment, const Stop& stop);

/// Throws `BadInput` with every problem of the experiment, its robot and its measurements. Trials of a target that
/// takes tests are those that the database holds of the same target: of the last run of the algorithm, and those that
/// were carried out one by one. Of a program that is the target of the same `version`.
OpenExperiment open_experiment(const CommonOptions& options);
/// The same for an experiment file whose content would be `text`.
OpenExperiment open_experiment(const CommonOptions& options, const std::string& text,
                               std::shared_ptr<const PluginCatalog> catalog);
/// The same with neither recorded trials nor those of a database.
OpenExperiment open_experiment_without_trials(const CommonOptions& options, const std::string& text);

}  // namespace lacuna
