#include "app/terminal/options.h"
#include "app/terminal/output.h"
#include "app/workspace/newest_setting.h"
#include "command_line/usage_error.h"
#include "foundation/text/counted.h"
#include "foundation/processes/interrupt.h"
#include "foundation/text/problem.h"
#include "shapes/shape_reading.h"
#include "storage/files/log_left.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iterator>
#include <optional>
#include <utility>

/// What runs found of a robot's shape: README.md beside it.
namespace lacuna {
namespace {

enum ExitCode { kDone = 0, kFailed = 1, kBadInput = 2, kInterrupted = 75 };

constexpr const char* kNoShapes =
    "have no distance of parts from the target's; give the experiment a simulated target and estimation.objective = "
    "\"part_distance\"";

struct ShapesOptions {
  std::filesystem::path database;
  std::vector<std::string> experiments;
  std::filesystem::path folder;
  std::vector<std::filesystem::path> plugin_paths;
};

/// In the order in which they were first run, or as asked for.
std::vector<std::string> experiments_of(const std::vector<EeaRunListing>& runs, const ShapesOptions& options) {
  std::vector<std::string> names;
  for (const EeaRunListing& run : runs)
    if (std::find(names.begin(), names.end(), run.experiment) == names.end()) names.push_back(run.experiment);
  if (options.experiments.empty()) return names;
  for (const std::string& wanted : options.experiments)
    if (std::find(names.begin(), names.end(), wanted) == names.end())
      throw_problem({options.database.string()},
                    fmt::format("has no run of \"{}\"{}", wanted, did_you_mean(wanted, names)));
  return options.experiments;
}

/// The newest replicates of one experiment.
struct NewestRuns {
  std::vector<EeaRunListing> ended;
  std::size_t unfinished = 0;  ///< which are left out: their last pass is not the last
};

NewestRuns newest_runs(const Database& database, const std::vector<EeaRunListing>& runs, const std::string& name) {
  std::vector<EeaRunListing> of_experiment;
  std::copy_if(runs.begin(), runs.end(), std::back_inserter(of_experiment),
               [&](const EeaRunListing& run) { return run.experiment == name; });
  NewestRuns newest{newest_setting(database, of_experiment)};
  newest.unfinished = std::erase_if(
      newest.ended, [](const EeaRunListing& run) { return run.ending != "done" || run.passes_done == 0; });
  return newest;
}

void say_unfinished(const std::string& experiment, std::size_t unfinished) {
  if (unfinished == 0) return;
  fmt::print(stderr, "{}: {} left out, not ended; to continue interrupted runs: lacuna run FILE --resume\n", experiment,
             counted(unfinished, "run"));
}

/// Experiments that do not speak of shapes are passed over, but one that was asked for is not.
std::vector<ShapeStudy> read_studies(Database& database, const ShapesOptions& options) {
  const std::vector<EeaRunListing> runs = eea_runs(database);
  const bool asked = !options.experiments.empty();
  bool some_ended = false;
  std::vector<ShapeStudy> studies;
  for (const std::string& name : experiments_of(runs, options)) {
    const NewestRuns newest = newest_runs(database, runs, name);
    const bool ended = !newest.ended.empty();
    some_ended = some_ended || ended;
    auto study = ended ? read_shape_study(database, newest.ended, options.plugin_paths) : std::nullopt;
    if (study || !ended) say_unfinished(name, newest.unfinished);
    if (study) studies.push_back(std::move(*study));
    if (!ended && asked) throw_problem({options.database.string()}, fmt::format("no run of {} has ended", name));
    if (ended && !study && asked)
      throw_problem({options.database.string()}, fmt::format("the runs of {} {}", name, kNoShapes));
  }
  if (studies.empty() && some_ended)
    throw_problem({options.database.string()}, fmt::format("the runs of all of its experiments {}", kNoShapes));
  if (studies.empty()) throw_problem({options.database.string()}, "has no finished run; make one: lacuna run FILE");
  return studies;
}

void shapes(const ShapesOptions& options) {
  const LogLeft log(options.database);
  Database database = Database::open_read_only(options.database, when_interrupted());
  const std::vector<ShapeStudy> studies = read_studies(database, options);
  make_output_folder(options.folder);
  fmt::print("{}", shape_table(studies));
  const auto place = [&](const char* name) { return file_for_picture(options.folder, name); };
  const std::filesystem::path errors = place("shape_errors.svg"), progress = place("shape_progress.svg"),
                              models = place("shape_models.svg");
  write_svg(shape_errors(studies), errors, when_interrupted());
  write_svg(shape_progress(studies), progress, when_interrupted());
  std::vector<RobotRow> rows;
  for (const ShapeStudy& study : studies) rows.push_back({study.experiment, study.samples});
  write_robots_svg("Models of a typical run of each experiment, in their start position", rows, models);
  for (const std::filesystem::path& file : {errors, progress, models}) fmt::print("{}\n", file.string());
}

void add_options(CLI::App& program, ShapesOptions& options) {
  add_database_argument(program, options.database);
  program
      .add_option("--experiment", options.experiments,
                  "Experiment to show (default: all in the database); may be repeated")
      ->allow_extra_args(false)
      ->option_text("NAME");
  program.add_option("--out", options.folder, "Folder for the pictures (default: the current folder)")
      ->option_text("FOLDER");
  program.add_option("--plugin-path", options.plugin_paths, "Folder with plugins, searched before all others")
      ->allow_extra_args(false)
      ->option_text("FOLDER");
  program.footer("Exit codes: 0 done, 1 failed, 2 bad input, 75 interrupted and to be run again.");
}

int told(const std::exception& error, int code) {
  fmt::print(stderr, "{}\n", error.what());
  return code;
}

int run_program(int argc, char** argv) {
  CLI::App program("Compare the robot shapes that runs found with the target's: a table and SVG pictures",
                   "lacuna-shapes");
  ShapesOptions options;
  add_options(program, options);
  watch_for_interrupts();
  try {
    program.parse(argc, argv);
    shapes(options);
    return kDone;
  } catch (const CLI::Success& help) {
    return program.exit(help) == 0 ? kDone : kFailed;
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "{}\n", usage_sentence(program, error, argc, argv));
    return kBadInput;
  } catch (const BadInput& error) {
    return told(error, kBadInput);
  } catch (const Interrupted& error) {
    return told(error, kInterrupted);
  } catch (const std::exception& error) {
    return told(error, kFailed);
  }
}

}  // namespace
}  // namespace lacuna

int main(int argc, char** argv) { return lacuna::run_program(argc, argv); }
