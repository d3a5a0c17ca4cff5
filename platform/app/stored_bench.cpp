#include "app/stored_bench.h"

#include "app/used_plugins.h"

#include <fmt/format.h>

#include <algorithm>

namespace lacuna {

EeaRunListing choose_run(const Database& database, std::optional<std::int64_t> number) {
  const std::vector<EeaRunListing> runs = eea_runs(database);
  const SourceLocation file{database.file().string()};
  if (runs.empty()) throw_problem(file, "has no run; lacuna run FILE makes one");
  if (!number && runs.size() > 1)
    throw_problem(file, fmt::format("has {} runs; choose one with --run, lacuna runs lists them", runs.size()));
  if (!number) return runs.front();
  const auto found =
      std::find_if(runs.begin(), runs.end(), [&](const EeaRunListing& run) { return run.run.value == *number; });
  if (found == runs.end()) throw_problem(file, fmt::format("has no run {}; lacuna runs lists them", *number));
  return *found;
}

StoredBench open_stored(const Database& database, const EeaRunListing& run,
                        const std::vector<std::filesystem::path>& plugin_paths) {
  StoredBench stored;
  stored.listing = run;
  stored.run = stored_run(database, run.run);
  CommonOptions options;
  options.experiment = stored.run.experiment.file;
  options.overrides = stored.run.experiment.overrides;
  auto catalog = std::make_shared<const PluginCatalog>(plugin_search_path(plugin_paths));
  stored.bench = std::make_unique<EeaBench>(open_rig(options, stored.run.experiment.text, catalog));
  for (const PluginFileRecord& now : plugins_of_run(stored.bench->rig().experiment, *catalog))
    if (std::none_of(stored.run.plugins.begin(), stored.run.plugins.end(),
                     [&](const PluginFileRecord& then) { return then.sha256 == now.sha256; }))
      stored.doubts.push_back(now.file + " is another build than the run's; digits may differ");
  return stored;
}

}  // namespace lacuna
