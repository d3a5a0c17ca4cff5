#include "app/workspace/used_plugins.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace lacuna {
namespace {

using Components = std::set<std::pair<std::string, std::string>>;  // as users call the kind, and the name

template <class Interface>
void add(Components& used, const std::string& name) {
  used.emplace(ComponentKind<Interface>::noun, name);
}

void add_system(Components& used, const ModelSection& section) {
  add<RobotDefinition>(used, section.robot);
  for (const EffectEntry& effect : section.effects) add<PhysicalEffect>(used, effect.effect);
}

void add_search(Components& used, const SearchSection& section) {
  add<SearchStrategy>(used, section.search.name);
  for (const MutationEntry& entry : section.mutation) add<MutationOperator>(used, entry.mutation.name);
}

Components of_model(const Experiment& experiment) {
  Components used;
  add<TargetSystem>(used, experiment.target.kind);
  add_system(used, experiment.model);
  add_system(used, experiment.target.simulated.system);
  return used;
}

Components of_run(const Experiment& experiment) {
  Components used = of_model(experiment);
  add<ModelEncoding>(used, experiment.model.encoding.name);
  add<TestEncoding>(used, experiment.test.encoding.name);
  add_search(used, experiment.estimation.search);
  add_search(used, experiment.exploration.search);
  add<FitnessMetric>(used, experiment.estimation.metric.name);
  add<ObjectiveMetric>(used, experiment.estimation.objective);
  add<TestFitness>(used, experiment.exploration.fitness.name);
  for (const MixEntry& entry : experiment.exploration.mix) add<TestFitness>(used, entry.fitness.name);
  return used;
}

std::vector<PluginFileRecord> files_of(const Components& used, const PluginCatalog& catalog) {
  std::vector<PluginFileRecord> files;
  for (const PluginListing& listing : catalog.list()) {
    const bool known =
        std::any_of(files.begin(), files.end(), [&](const auto& file) { return file.sha256 == listing.sha256; });
    if (used.contains({listing.kind, listing.name}) && !known)
      files.push_back({listing.file.string(), listing.sha256, listing.build_id});
  }
  return files;
}

}  // namespace

std::vector<PluginFileRecord> plugins_of_model(const Experiment& experiment, const PluginCatalog& catalog) {
  return files_of(of_model(experiment), catalog);
}

std::vector<PluginFileRecord> plugins_of_run(const Experiment& experiment, const PluginCatalog& catalog) {
  return files_of(of_run(experiment), catalog);
}

}  // namespace lacuna
