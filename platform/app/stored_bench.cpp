#include "app/stored_bench.h"

#include "app/run_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace lacuna {
namespace {

/// Names in an experiment are taken from the folder of its file, and the database has that name as it was given.
std::unique_ptr<EeaBench> open_bench(const CommonOptions& options, const std::string& text,
                                     std::shared_ptr<const PluginCatalog> catalog) {
  try {
    return std::make_unique<EeaBench>(open_rig(options, text, std::move(catalog)));
  } catch (const BadInput& bad) {
    if (options.experiment.is_absolute() || std::filesystem::exists(options.experiment)) throw;
    std::vector<Problem> problems = bad.problems();
    const SourceLocation file{options.experiment.string()};
    problems.push_back({file, "is not in this folder, " + std::filesystem::current_path().string() +
                                  "; run the command in the folder where the run was begun"});
    throw BadInput(std::move(problems));
  }
}

std::string key_of_override(const std::string& text) { return text.substr(0, text.find('=')); }

/// A key that is set anew loses its old value.
std::vector<std::string> put_over(std::vector<std::string> overrides, const std::vector<std::string>& newer) {
  for (const std::string& one : newer)
    std::erase_if(overrides, [&](const std::string& old) { return key_of_override(old) == key_of_override(one); });
  overrides.insert(overrides.end(), newer.begin(), newer.end());
  return overrides;
}

}  // namespace

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

StoredBench open_stored(const Database& database, const EeaRunListing& run, CommonOptions options) {
  StoredBench stored;
  stored.listing = run;
  stored.run = stored_run(database, run.run);
  if (options.experiment.empty()) options.experiment = stored.run.experiment.file;
  options.overrides = put_over(stored.run.experiment.overrides, options.overrides);
  auto catalog = std::make_shared<const PluginCatalog>(plugin_search_path(options.plugin_paths));
  stored.bench = open_bench(options, stored.run.experiment.text, catalog);
  for (const std::string& changed : changed_files(stored.run, stored.bench->rig().experiment, *catalog))
    stored.doubts.push_back(fmt::format("run {} was begun with {}; digits may differ", run.run.value, changed));
  return stored;
}

StoredBench open_stored(const Database& database, const EeaRunListing& run,
                        const std::vector<std::filesystem::path>& plugin_paths) {
  CommonOptions options;
  options.plugin_paths = plugin_paths;
  return open_stored(database, run, std::move(options));
}

}  // namespace lacuna
