#pragma once

#include "app/runs/open_eea_run.h"
#include "config/experiment_reader.h"
#include "plugins/built_catalog.h"
#include "support/small_experiment.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace lacuna {

/// Keeps everything that a run says.
class MemoryJournal : public EeaJournal {
 public:
  void add(ModelRow row) override { models.push_back(std::move(row)); }
  void add(TestRow row) override { tests.push_back(std::move(row)); }
  void add(TargetTrialRow row, const Trial& trial) override {
    trial_rows.push_back(std::move(row));
    trials.push_back(trial);
  }
  void add_prediction(std::uint64_t model, int, const TimeSeries&, const TimeSeries&) override {
    ++predictions;
    if (model >= models.size()) ++predictions_of_nobody;
  }
  void add(PassRow row) override { passes.push_back(std::move(row)); }
  void note_failure(const FailedTrialRecord& failed) override { failures.push_back(failed); }
  void checkpoint(const EeaState& state, bool) override { checkpoints.push_back(save(state)); }

  std::vector<ModelRow> models;
  std::vector<TestRow> tests;
  std::vector<TargetTrialRow> trial_rows;
  std::vector<Trial> trials;
  std::vector<PassRow> passes;
  std::vector<FailedTrialRecord> failures;
  std::vector<std::vector<double>> checkpoints;
  int predictions = 0;
  int predictions_of_nobody = 0;  ///< by models without a row before, where the run began here
};

/// Populations of a dozen and tests of 0.3 s: a few hundredths of a second.
inline const std::string kSmallExperiment =
    small_experiment("0.3", "population = 12, keep = 6, generations = 5", "population = 6, keep = 3, generations = 3");

/// An experiment ready to run, with some keys put beside the text.
inline std::unique_ptr<OpenEeaRun> small_bench(const std::vector<std::string>& overrides = {},
                                               const std::string& text = kSmallExperiment, bool measured = false) {
  OpenExperiment opened;
  opened.experiment =
      read_experiment_text(text, std::filesystem::path(LACUNA_SOURCE_DIRECTORY) / "experiments/small.toml", overrides);
  opened.catalog = std::make_shared<const PluginCatalog>(plugin_search_path({}));
  opened.definition = define_model(opened.experiment, *opened.catalog);
  opened.model = compile(opened.definition.structure, opened.definition.engine);
  if (measured)
    opened.trials = RecordingReader(opened.experiment.target.recording, opened.definition.structure.robot, {}).read();
  return std::make_unique<OpenEeaRun>(std::move(opened));
}

/// A run of it whose truth nobody asks for.
inline EeaRun run_of(const OpenEeaRun& opened, EeaJournal& journal) {
  return {.definition = opened.definition(),
          .journal = journal,
          .seed = 1,
          .replicate = 1,
          .truth = {},
          .target = nullptr,
          .progress = {}};
}

/// Runs it from `state` to its end.
inline void run(const OpenEeaRun& opened, EeaJournal& journal, EeaState& state, int threads = 1,
                std::uint64_t seed = 1) {
  const ReplicateTarget target(opened, seed, 1);
  eea_loop({.definition = opened.definition(),
            .journal = journal,
            .seed = seed,
            .replicate = 1,
            .work = {threads},
            .truth = opened.truth(1),
            .target = opened.target() ? &opened.target()->structure.robot : nullptr,
            .progress = {}},
           target.target(), state);
}

inline MemoryJournal run(const OpenEeaRun& opened, int threads = 1, std::uint64_t seed = 1) {
  MemoryJournal journal;
  EeaState state = beginning(opened);
  run(opened, journal, state, threads, seed);
  return journal;
}

/// What a run that ended at one of its checkpoints goes on from: with the trials and models that it had stored by then.
inline EeaState state_at(const OpenEeaRun& opened, const MemoryJournal& whole, const std::vector<double>& checkpoint) {
  EeaState state = load_state(checkpoint);
  for (std::size_t i = 0; i < state.trials.size(); ++i) {
    const std::uint64_t test = *whole.trial_rows[i].test;
    state.trials[i].test = test;
    state.trials[i].drive = opened.definition().decode_test(whole.tests[test].genome);
    state.trials[i].trial = whole.trials[i];
  }
  if (state.phase == Phase::estimation && !state.search.empty())
    for (const ModelRow& row : whole.models)
      if (row.pass == state.pass && row.number < state.models) state.evaluated.push_back(row);
  return state;
}

}  // namespace lacuna
