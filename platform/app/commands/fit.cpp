#include "app/commands/commands.h"
#include "app/terminal/options.h"
#include "app/terminal/output.h"
#include "app/terminal/progress_line.h"
#include "app/terminal/time_limit.h"
#include "app/workspace/experiment_workflow.h"
#include "foundation/text/counted.h"
#include "report/json/comparison_json.h"
#include "report/text/comparison_text.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace lacuna {
namespace {

std::string time_of(const ExperimentWorkflow::Fitted& fitted) {
  if (fitted.known) return "known";
  return format_duration(fitted.result.seconds) + (fitted.result.stopped ? ", stopped before it converged" : "");
}

void run_fit(const CommonOptions& options) {
  check_output(options.json);
  ExperimentWorkflow workflow(options);
  const ExperimentWorkflow::Fitted fitted = workflow.fit_model(ExperimentWorkflow::AtTimeLimit::best_so_far);
  options.stop.lift_limit();  // what follows is quick
  if (!takes_standard_output(options.json)) {
    fmt::print("{} · revision {} · {} · {}\n", workflow.opened().experiment.name, workflow.revision().number,
               counted(workflow.opened().count(false), "fit trial"), time_of(fitted));
    fmt::print("{}", fit_text(fitted.result));
    fmt::print("{}", data_checks_text(workflow.doubts(fitted.result)));
    if (!fitted.result.stopped) fmt::print("→ {}\n", command_to_type("compare", options));
  }
  if (options.json) write_output(*options.json, fit_json(workflow.opened().experiment.name, fitted.result));
  if (fitted.result.stopped)
    throw Interrupted(options.stop.reason_of_limit() +
                      "; the best values so far are stored. Run the command again with more time");
  workflow.recorder().done();
}

}  // namespace

void add_fit_command(CLI::App& program) {
  auto options = std::make_shared<CommonOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command =
      program.add_subcommand("fit", "Fit the model's free values to the recordings that are not held out");
  add_experiment_options(*command, *options);
  add_work_options(*command, *options);
  add_time_limit_option(*command, *options);
  command->callback([options] { run_fit(*options); });
}

}  // namespace lacuna
