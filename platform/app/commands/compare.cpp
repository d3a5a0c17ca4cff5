#include "app/commands/commands.h"
#include "app/terminal/options.h"
#include "app/terminal/output.h"
#include "app/terminal/time_limit.h"
#include "app/workspace/experiment_workflow.h"
#include "foundation/text/plain_text.h"
#include "foundation/text/shell_word.h"
#include "report/figures/comparison_pictures.h"
#include "report/figures/where_pictures.h"
#include "report/json/comparison_json.h"
#include "report/json/where_json.h"
#include "report/text/advice_text.h"
#include "report/text/comparison_text.h"
#include "report/text/where_text.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace lacuna {
namespace {

struct CompareOptions : CommonOptions {
  bool as_is = false, cross_check = false;
  std::optional<std::string> csv;
  std::filesystem::path out;
};

void run_compare(const CompareOptions& options) {
  check_output(options.json, options.csv);
  check_output_folder(options.out);
  ExperimentWorkflow workflow(options);
  const ExperimentWorkflow::Fitted fitted =
      options.as_is ? ExperimentWorkflow::Fitted{as_written(workflow.opened().definition), false}
                    : workflow.fit_model();
  const ExperimentWorkflow::Compared compared =
      workflow.compare_model(fitted.result, !options.as_is, true, options.cross_check);
  const WhereItFails where = workflow.where_it_fails(fitted.result, compared.result);
  options.stop.lift_limit();  // what follows is quick
  // The database has no folders of this machine, so the command that it keeps names the file alone.
  const std::string diagnose = "lacuna diagnose " + shell_word(options.experiment.filename().string());
  workflow.recorder().keep_where_it_fails(compared.id,
                                          where_document(where, compared.result, advice_on(compared.result, diagnose)));
  const ComparisonHeading heading{
      workflow.opened().experiment.name,
      compared.look,
      !options.as_is,
      fitted.known,
      fitted.result.seconds,
      known_setups(workflow.opened().definition, workflow.opened().experiment.target.recording)};

  const std::string advice = advice_text(compared.result, command_to_type("diagnose", options));
  if (!takes_standard_output(options.json) && !takes_standard_output(options.csv)) {
    fmt::print("{}", comparison_text(heading, compared.result, fitted.result));
    if (compared.result.cross_check) fmt::print("{}", cross_check_text(*compared.result.cross_check));
    fmt::print("{}", fit_text(fitted.result));
    fmt::print("{}", data_checks_text(workflow.doubts(fitted.result)));
    fmt::print("{}", where_text(where));
    fmt::print("{}", advice);
  }
  if (options.json)
    write_output(*options.json, comparison_json(heading, compared.result, fitted.result, where, advice));
  if (options.csv) write_output(*options.csv, comparison_csv(compared.result));
  if (!options.out.empty()) {
    make_output_folder(options.out);
    const std::string title = fmt::format("{} · revision {}", heading.experiment, workflow.revision().number);
    FileNames names;
    draw_comparison(compared.result, title, options.out, names, options.stop);
    draw_where(where, title, options.out, names, options.stop);
    write_predictions(compared.result, options.out, names);
    if (!options.quiet) fmt::print(stderr, "pictures and predictions are in {}\n", plain_text(options.out.string()));
  }
  workflow.recorder().done();
}

}  // namespace

void add_compare_command(CLI::App& program) {
  auto options = std::make_shared<CompareOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("compare", "Fit the model and compare it with every measured trial");
  add_experiment_options(*command, *options);
  add_work_options(*command, *options);
  add_time_limit_option(*command, *options);
  command->add_flag("--as-is", options->as_is, "Do not fit; use the values that are written in the files");
  command->add_flag(
      "--cross-check", options->cross_check,
      "Also predict with the other physics engine (ode: Open Dynamics Engine; articulated: Lacuna's own) and "
      "print the difference");
  add_result_option(*command, "csv", options->csv, "Scores as CSV, to standard output or FILE");
  command->add_option("--out", options->out, "Folder for pictures (SVG) and predictions (CSV)")->option_text("FOLDER");
  command->callback([options] { run_compare(*options); });
}

}  // namespace lacuna
