#include "app/runs/open_stored_run.h"

#include "app/workspace/run_inputs.h"
#include "config/overrides.h"
#include "foundation/text/shell_word.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace lacuna {
namespace {

/// Names in an experiment are taken from the folder of its file, and the database has that name as it was given.
std::unique_ptr<OpenEeaRun> open_eea_run(const CommonOptions& options, const std::string& text,
                                         std::shared_ptr<const PluginCatalog> catalog, StoredProgram program) {
  try {
    OpenExperiment opened = open_experiment(options, text, std::move(catalog));
    if (program == StoredProgram::refused)
      opened.experiment.target.process.refused =
          "target.command: this program is named by the database, not by a file of yours, so it is not started";
    return std::make_unique<OpenEeaRun>(std::move(opened));
  } catch (const BadInput& bad) {
    if (options.experiment.is_absolute() || std::filesystem::exists(options.experiment)) throw;
    std::vector<Problem> problems = bad.problems();
    const SourceLocation file{options.experiment.string()};
    problems.push_back({file, "is not in this folder, " + std::filesystem::current_path().string() +
                                  "; run the command in the folder where the run was begun"});
    throw BadInput(std::move(problems));
  }
}

/// Setting a key again replaces its old value.
std::vector<std::string> put_over(std::vector<std::string> overrides, const std::vector<std::string>& newer) {
  for (const std::string& one : newer)
    std::erase_if(overrides, [&](const std::string& old) { return overridden_key(old) == overridden_key(one); });
  overrides.insert(overrides.end(), newer.begin(), newer.end());
  return overrides;
}

/// A word as a shell takes it. What a terminal would hide, act on or show in another order is written as its bytes.
std::string visible_word(const std::string& word) {
  const auto is_plain = [](char c) { return c >= ' ' && c <= '~'; };
  if (std::all_of(word.begin(), word.end(), is_plain)) return shell_word(word);
  std::string quoted = "$'";
  for (const char c : word) {
    if (!is_plain(c))
      quoted += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    else
      quoted += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  }
  return quoted + "'";
}

}  // namespace

EeaRunListing choose_run(const Database& database, std::optional<std::int64_t> number) {
  const std::vector<EeaRunListing> runs = eea_runs(database);
  const SourceLocation file{database.file().string()};
  if (runs.empty()) throw_problem(file, "has no run; make one: lacuna run FILE");
  if (!number && runs.size() > 1)
    throw_problem(file, fmt::format("has {} runs; choose one with --run (lacuna runs lists them)", runs.size()));
  if (!number) return runs.front();
  const auto found =
      std::find_if(runs.begin(), runs.end(), [&](const EeaRunListing& run) { return run.run.value == *number; });
  if (found == runs.end()) throw_problem(file, fmt::format("has no run {}; lacuna runs lists them", *number));
  return *found;
}

OpenStoredRun open_stored(const Database& database, const EeaRunListing& run, CommonOptions options,
                          StoredProgram program) {
  OpenStoredRun stored;
  stored.listing = run;
  stored.run = stored_run(database, run.run);
  if (options.experiment.empty()) options.experiment = stored.run.experiment.file;
  if (options.database.empty()) options.database = database.file();  // not one of the experiment's name, here by chance
  options.overrides = put_over(stored.run.experiment.overrides, options.overrides);
  options.decided = stored.run.experiment.decided;
  auto catalog = std::make_shared<const PluginCatalog>(plugin_search_path(options.plugin_paths));
  stored.opened = open_eea_run(options, stored.run.experiment.text, catalog, program);
  for (const std::string& changed : changed_files(stored.run, stored.opened->opened().experiment, *catalog))
    stored.doubts.push_back(fmt::format("run {} was begun with {}; digits may differ", run.run.value, changed));
  for (const PluginFileRecord& earlier : stored.run.earlier_plugins)
    stored.doubts.push_back(
        fmt::format("run {} continued with another build of a plugin: {}; its rows come from both builds",
                    run.run.value, earlier.file));
  return stored;
}

OpenStoredRun open_stored(const Database& database, const EeaRunListing& run,
                          const std::vector<std::filesystem::path>& plugin_paths, StoredProgram program) {
  CommonOptions options;
  options.plugin_paths = plugin_paths;
  options.stop = database.stop();
  return open_stored(database, run, std::move(options), program);
}

std::string program_line(const Experiment& experiment) {
  if (experiment.target.kind != "process") return {};
  const ProcessSource& source = experiment.target.process;
  std::string line = source.folder.empty() ? "" : "cd " + visible_word(source.folder.string()) + " && ";
  for (const auto& [name, value] : source.environment) line += visible_word(name) + "=" + visible_word(value) + " ";
  std::vector<std::string> words;
  for (const std::string& word : source.command) words.push_back(visible_word(word));
  return line + fmt::format("{}", fmt::join(words, " "));
}

}  // namespace lacuna
