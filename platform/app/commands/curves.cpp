#include "app/commands/commands.h"
#include "app/terminal/options.h"
#include "app/terminal/output.h"
#include "app/workspace/newest_setting.h"
#include "foundation/processes/interrupt.h"
#include "foundation/text/counted.h"
#include "foundation/text/plain_text.h"
#include "foundation/text/problem.h"
#include "report/figures/learning_curves.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <mutex>
#include <set>

namespace lacuna {
namespace {

struct CurvesOptions {
  std::vector<std::filesystem::path> databases;
  std::vector<std::string> experiments;
  std::string error;
  std::string against;
  std::filesystem::path folder;
};

/// The newest replicates of one experiment in one database.
struct NamedRuns {
  std::string experiment;
  std::filesystem::path database;
  std::vector<std::vector<PassRow>> passes;
  std::size_t unfinished = 0;  ///< runs, which are left out: they would seem to have stopped learning
  std::size_t others = 0;      ///< runs begun with other settings, or run again since
};

void add_runs(Database& database, std::vector<NamedRuns>& named) {
  std::vector<EeaRunListing> runs = eea_runs(database);
  std::vector<std::string> names;
  for (const EeaRunListing& run : runs)
    if (std::find(names.begin(), names.end(), run.experiment) == names.end()) names.push_back(run.experiment);
  for (const std::string& name : names) {
    std::vector<EeaRunListing> of_experiment;
    std::copy_if(runs.begin(), runs.end(), std::back_inserter(of_experiment),
                 [&](const EeaRunListing& run) { return run.experiment == name; });
    NamedRuns added{name, database.file(), {}};
    std::mutex unused;
    const std::vector<EeaRunListing> newest = newest_setting(database, of_experiment);
    added.others = of_experiment.size() - newest.size();
    for (const EeaRunListing& run : newest)
      if (run.ending == "done")
        added.passes.push_back(EeaStore(database, unused, run.run, {}).passes());
      else
        ++added.unfinished;
    named.push_back(std::move(added));
  }
}

/// Labels that distinguish experiments of several databases: the names of the files, or their paths.
void tell_apart(std::vector<NamedRuns>& named) {
  std::map<std::string, int> times, times_in_file;
  for (const NamedRuns& runs : named) {
    ++times[runs.experiment];
    ++times_in_file[runs.experiment + runs.database.filename().string()];
  }
  for (NamedRuns& runs : named)
    if (times[runs.experiment] > 1)
      runs.experiment += " in " + (times_in_file[runs.experiment + runs.database.filename().string()] > 1
                                       ? runs.database.string()
                                       : runs.database.filename().string());
}

std::vector<std::string> names_of(const std::vector<NamedRuns>& named) {
  std::vector<std::string> names;
  for (const NamedRuns& runs : named) names.push_back(runs.experiment);
  return names;
}

bool is_there(const std::string& name, const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void check_name(const std::string& option, const std::string& name, const std::vector<std::string>& there) {
  if (!is_there(name, there))
    throw_problem({}, fmt::format("{} {}: no run of it has ended{}; there is {}", option, name,
                                  did_you_mean(name, there), fmt::join(there, ", ")));
}

void say_what_is_left_out(const NamedRuns& runs) {
  const auto say = [&](std::size_t count, const std::string& why) {
    if (count > 0)
      std::fprintf(stderr, "%s\n",
                   fmt::format("{}: {} {}", plain_text(runs.experiment), counted(count, "run"), why).c_str());
  };
  say(runs.unfinished, "left out, not ended; to continue interrupted runs: lacuna run FILE --resume");
  say(runs.others, "left out: other settings than the newest run, or replaced by a newer run");
}

/// What all databases have of the experiments that were asked for.
std::vector<NamedRuns> read_runs(const CurvesOptions& options) {
  std::vector<NamedRuns> named;
  std::set<std::filesystem::path> seen;
  for (const std::filesystem::path& file : options.databases) {
    if (!seen.insert(std::filesystem::weakly_canonical(file)).second) continue;
    Database database = Database::open_read_only(file, when_interrupted());
    add_runs(database, named);
  }
  for (const NamedRuns& runs : named) say_what_is_left_out(runs);
  std::erase_if(named, [](const NamedRuns& runs) { return runs.passes.empty(); });
  if (named.empty())
    throw_problem({options.databases.front().string()}, "has no finished run; make one: lacuna run FILE");
  for (const std::string& name : options.experiments) check_name("--experiment", name, names_of(named));
  if (!options.experiments.empty())
    std::erase_if(named, [&](const NamedRuns& runs) { return !is_there(runs.experiment, options.experiments); });
  tell_apart(named);
  if (!options.against.empty()) check_name("--against", options.against, names_of(named));
  return named;
}

/// What all experiments can be compared by.
std::string chosen_error(const CurvesOptions& options, const std::vector<NamedRuns>& named) {
  if (options.error == "score") return {};
  std::vector<std::vector<PassRow>> all;
  for (const NamedRuns& runs : named) all.insert(all.end(), runs.passes.begin(), runs.passes.end());
  const std::vector<std::string> errors = errors_in(all);
  if (options.error.empty()) return errors.empty() ? std::string() : errors.front();
  if (std::find(errors.begin(), errors.end(), options.error) == errors.end())
    throw_problem({}, fmt::format("--error {}: not all of these runs have this error{}; all have score{}",
                                  options.error, did_you_mean(options.error, errors),
                                  errors.empty() ? "" : fmt::format(", {}", fmt::join(errors, ", "))));
  return options.error;
}

void curves(const CurvesOptions& options) {
  const std::vector<NamedRuns> named = read_runs(options);
  const std::string error = chosen_error(options, named);
  std::vector<LearningCurve> all;
  for (const NamedRuns& runs : named) all.push_back(learning_curve(runs.experiment, runs.passes, error));
  const auto against = std::find_if(all.begin(), all.end(),
                                    [&](const LearningCurve& curve) { return curve.experiment == options.against; });
  make_output_folder(options.folder);
  fmt::print("{}", learning_table(all, against == all.end() ? nullptr : &*against));
  for (const auto& [name, figure] :
       {std::pair{"error_by_trials.svg", error_by_trials(all)}, std::pair{"error_by_steps.svg", error_by_steps(all)}}) {
    const std::filesystem::path file = file_for_picture(options.folder, name);
    write_svg(figure, file, when_interrupted());
    fmt::print("{}\n", file.string());
  }
}

}  // namespace

void add_curves_command(CLI::App& program) {
  auto options = std::make_shared<CurvesOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand(
      "curves", "Draw learning curves: error over trials of the target and over simulated steps");
  add_databases_argument(*command, options->databases);
  command->add_option("--experiment", options->experiments, "Experiment to draw (default: all); may be repeated")
      ->allow_extra_args(false)
      ->option_text("NAME");
  command
      ->add_option(
          "--error", options->error,
          "Error to draw: \"score\", or the error of a parameter against its true value, such as \"body.*.mass\" "
          "(default: the first that is present in all runs)")
      ->option_text("NAME");
  command
      ->add_option("--against", options->against,
                   "Also print how many trials each experiment needs to reach the final error of experiment NAME")
      ->option_text("NAME");
  command->add_option("--out", options->folder, "Folder for the pictures (default: the current folder)")
      ->option_text("FOLDER");
  command->callback([options] { curves(*options); });
}

}  // namespace lacuna
