#include "app/workspace/diagnosis_work.h"

#include "app/terminal/output.h"
#include "app/terminal/progress_line.h"
#include "app/terminal/time_limit.h"
#include "app/workspace/scale_note.h"
#include "app/workspace/experiment_workflow.h"
#include "answer/find_missing_effects.h"
#include "candidates/effect_filter.h"
#include "documents/diagnosis_json.h"
#include "foundation/text/counted.h"
#include "foundation/plugins/plugin_call.h"
#include "report/figures/diagnosis_pictures.h"
#include "report/text/diagnosis_text.h"

#include <fmt/format.h>

namespace lacuna {
namespace {

/// Continues from the state of an interrupted call, and stores its state.
Diagnosis make_diagnosis(const DiagnoseOptions& options, ExperimentWorkflow& workflow) {
  workflow.recorder().check_kept();
  const OpenExperiment& opened = workflow.opened();
  const std::optional<KeptFits> before =
      workflow.recorder().unfinished_diagnosis(workflow.revision(), opened, options.among);
  if (before && !options.quiet)
    fmt::print(stderr, "continuing: {} known from an earlier call\n", counted(before->size(), "model"));
  ProgressLine line(options.quiet);
  return find_missing_effects({.experiment = opened.experiment,
                               .catalog = *opened.catalog,
                               .definition = opened.definition,
                               .model = *opened.model,
                               .trials = opened.trials,
                               .among = options.among,
                               .seed = options.seed.value_or(opened.experiment.seed),
                               .work = workflow.work(line.callback()),
                               .known = before ? &*before : nullptr,
                               .keep = [&](const KeptFits& fits) {
                                 workflow.recorder().keep_unfinished(workflow.revision(), opened, options.among, fits);
                               }});
}

struct Found {
  Diagnosis diagnosis;
  bool known = false;  ///< it was in the database
};

Found find_diagnosis(const DiagnoseOptions& options, ExperimentWorkflow& workflow) {
  const OpenExperiment& opened = workflow.opened();
  if (const auto known = workflow.recorder().known_diagnosis(workflow.revision(), opened, options.among))
    return {read_diagnosis(*known), true};
  Diagnosis made = make_diagnosis(options, workflow);
  options.stop.lift_limit();  // what follows is quick
  if (made.stopped)
    workflow.recorder().keep_stopped(workflow.revision(), opened, options.among, made);
  else
    workflow.recorder().keep(workflow.revision(), opened, options.among, made);
  return {std::move(made)};
}

/// If an effect only compensates for a wrong scale of the readings, correct the scale instead of adding it.
std::string correction_before_adding(const OpenExperiment& opened, const Diagnosis& diagnosis) {
  if (diagnosis.verdict != Verdict::effect_found && diagnosis.verdict != Verdict::not_in_library) return "";
  const std::string lines = scale_correction(opened);
  return lines.empty() ? "" : "under [target.sensors]: " + lines;
}

}  // namespace

void carry_out_diagnosis(DiagnoseOptions options) {
  check_output(options.json);
  check_output_folder(options.out);
  ExperimentWorkflow workflow(options);
  options.among = check_effect_filter(options.among, workflow.opened().experiment, *workflow.opened().catalog,
                                      workflow.opened().definition);
  CallPage::allow_new_beginning(options.among.empty() && !options.time_limit);  // without a candidate that ends it
  const auto [diagnosis, known] = find_diagnosis(options, workflow);
  CallPage::allow_new_beginning(false);
  if (!takes_standard_output(options.json) && options.task.empty())  // what a task found is read from its plan
    fmt::print("{}{}",
               diagnosis_text(diagnosis, options.experiment.string(), options_to_type(options),
                              correction_before_adding(workflow.opened(), diagnosis)),
               known ? "(from the database)\n" : "");
  if (options.json) write_output(*options.json, diagnosis_json(diagnosis));
  if (!options.out.empty()) {
    make_output_folder(options.out);
    const std::string title =
        fmt::format("{} · revision {}", workflow.opened().experiment.name, workflow.revision().number);
    draw_diagnosis(diagnosis, title, options.out, options.stop);
    if (!options.quiet) fmt::print(stderr, "pictures are in {}\n", options.out.string());
  }
  if (diagnosis.stopped) throw TimeIsUp(options.stop.reason_of_limit() + ". " + diagnosis.stopped->next);
  workflow.recorder().done();
}

}  // namespace lacuna
