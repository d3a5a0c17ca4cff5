#include "app/commands/commands.h"
#include "app/terminal/options.h"
#include "app/terminal/output.h"
#include "app/workspace/integration.h"
#include "app/workspace/records.h"
#include "app/workspace/open_experiment.h"
#include "foundation/text/plain_text.h"
#include "foundation/text/shell_word.h"
#include "report/figures/history_picture.h"
#include "report/json/history_json.h"
#include "report/text/history_text.h"
#include "storage/files/log_left.h"
#include "storage/results/result_store.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <optional>

namespace lacuna {
namespace {

struct HistoryOptions : CommonOptions {
  std::optional<std::string> csv;
  std::filesystem::path out;
};

/// What the database has of the experiment, and what it lacks of the model that the file describes now.
struct StoredHistory {
  std::vector<HistoryRow> rows;
  int looks = 0;
  std::string missing;  ///< a sentence; empty: nothing
};

/// Why the current revision's errors are not all stored, or nothing.
std::string missing_of(const ResultStore& store, const std::optional<StoredRevision>& revision, bool has_held_out) {
  if (!revision) return "the model in the file is not stored yet";
  const auto compared = [&](bool held_out) {
    return store.latest_comparison(revision->id, ComparisonKind::refitted, held_out).has_value();
  };
  if (!compared(false)) return fmt::format("revision {} is not compared yet", revision->number);
  if (has_held_out && !compared(true))
    return fmt::format("revision {} is not compared with the held-out files yet", revision->number);
  return "";
}

/// Reads, and changes nothing: no fit, no look at held-out files, no revision.
StoredHistory stored_history(const std::filesystem::path& file, const OpenExperiment& opened) {
  if (!std::filesystem::exists(file)) return {{}, 0, "nothing is stored yet"};
  const LogLeft log(file);
  Database database = Database::open_read_only(file, opened.stop);
  const ResultStore store(database);
  const std::optional<ExperimentId> experiment = store.find_experiment(opened.experiment.name);
  if (!experiment) return {{}, 0, fmt::format("nothing of {} is stored yet", opened.experiment.name)};
  const std::optional<StoredRevision> now = store.find_revision(*experiment, revision_record(opened));
  StoredHistory history{store.history(*experiment), store.holdout_looks(*experiment),
                        missing_of(store, now, opened.count(true) > 0)};
  for (HistoryRow& row : history.rows) row.current = now && row.number == now->number;
  return history;
}

void run_history(const HistoryOptions& options) {
  check_output(options.json, options.csv);
  check_output_folder(options.out);
  OpenExperiment opened = open_experiment(options);
  settle_substeps(opened, opened.fit_trials(), options.work());
  const std::filesystem::path file = database_of(options, opened.experiment);
  const StoredHistory history = stored_history(file, opened);
  const std::vector<KnownSetup> setups = known_setups(opened.definition, opened.experiment.target.recording);
  const std::string next = history.missing.empty() ? "" : command_to_type("compare", options);
  if (!takes_standard_output(options.json) && !takes_standard_output(options.csv)) {
    fmt::print("{} · {}\n", plain_text(opened.experiment.name), plain_text(file.string()));
    if (!history.rows.empty()) fmt::print("{}", history_text(history.rows, history.looks, setups));
    if (!next.empty()) fmt::print("{}. Next: {}\n", history.missing, next);
  }
  if (options.json)
    write_output(*options.json, history_json(history.rows, history.looks, history.missing, next, setups));
  if (options.csv) write_output(*options.csv, history_csv(history.rows));
  if (!options.out.empty() && !history.rows.empty()) {
    make_output_folder(options.out);
    draw_history(history.rows, opened.experiment.name + " · error by revision", options.out, options.stop);
  }
}

}  // namespace

void add_history_command(CLI::App& program) {
  auto options = std::make_shared<HistoryOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("history", "Print the error of each revision of the model");
  add_experiment_options(*command, *options);
  add_work_options(*command, *options);
  add_result_option(*command, "csv", options->csv, "The table as CSV, to standard output or FILE");
  command->add_option("--out", options->out, "Folder for the picture (SVG)")->option_text("FOLDER");
  command->callback([options] { run_history(*options); });
}

}  // namespace lacuna
