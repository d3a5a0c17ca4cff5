#include "app/rig.h"

#include "config/experiment_reader.h"
#include "foundation/guarded_call.h"

#include <algorithm>

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
    return rig.catalog->make<TargetSystem>(target)->recorded({.trials = &reader, .simulator = nullptr});
  });
  return rig;
}

}  // namespace

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
  return assemble(read_experiment(options.experiment, options.overrides), std::move(catalog));
}

Rig open_rig(const CommonOptions& options, const std::string& text, std::shared_ptr<const PluginCatalog> catalog) {
  return assemble(read_experiment_text(text, options.experiment, options.overrides), std::move(catalog));
}

}  // namespace lacuna
