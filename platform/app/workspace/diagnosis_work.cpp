#include "app/workspace/diagnosis_work.h"

#include "app/terminal/output.h"
#include "app/terminal/progress_line.h"
#include "app/terminal/time_limit.h"
#include "app/workspace/scale_note.h"
#include "app/workspace/workbench.h"
#include "diagnosis/candidates/among.h"
#include "diagnosis/rounds/cut_trials.h"
#include "diagnosis/verdict/stopped_search.h"
#include "documents/diagnosis_json.h"
#include "foundation/counted.h"
#include "foundation/interrupt.h"
#include "foundation/plugin_call.h"
#include "report/figures/diagnosis_pictures.h"
#include "report/text/diagnosis_text.h"
#include "search/horizon_diagnosis.h"

#include <fmt/format.h>

namespace lacuna {
namespace {

DiagnosisTask task_of(const DiagnoseOptions& options, const Workbench& bench, ProgressLine& line) {
  const Rig& rig = bench.rig();
  return {.experiment = rig.experiment,
          .catalog = *rig.catalog,
          .definition = rig.definition,
          .model = *rig.model,
          .trials = rig.trials,
          .values = {},
          .among = options.among,
          .segment = rig.experiment.diagnosis.segment,
          .seed = options.seed.value_or(rig.experiment.seed),
          .threads = bench.threads(),
          .progress = line.callback()};
}

/// How many an earlier call need not have looked at in vain.
std::size_t kept_models(const UnfinishedSearch& search) {
  return search.fits.size() + (search.likelihoods ? search.likelihoods->tried.size() : 0);
}

/// Goes on from where an interrupted call came to, and keeps where it comes to itself.
Diagnosis make_diagnosis(const DiagnoseOptions& options, Workbench& bench) {
  bench.ledger().check_kept();
  const Rig& rig = bench.rig();
  const std::optional<UnfinishedSearch> before =
      bench.ledger().unfinished_diagnosis(bench.revision(), rig, options.among);
  if (before && !options.quiet)
    fmt::print(stderr, "going on after {}, which an earlier call had done\n", counted(kept_models(*before), "model"));
  ProgressLine line(options.quiet);
  const SearchMemory memory{before ? &*before : nullptr, [&](const UnfinishedSearch& search) {
                              bench.ledger().keep_unfinished(bench.revision(), rig, options.among, search);
                            }};
  std::vector<std::string> not_told;
  const FreeRunFit fit = [&] {
    const FitResult result = bench.fit_model().result;
    not_told = result.cannot_tell;
    return result.parameters();
  };
  Diagnosis diagnosis = find_missing_effects(task_of(options, bench, line), memory, fit);
  diagnosis.findings.insert(diagnosis.findings.end(), not_told.begin(), not_told.end());
  return diagnosis;
}

struct Found {
  Diagnosis diagnosis;
  bool known = false;  ///< it was in the database
};

Found find_diagnosis(const DiagnoseOptions& options, Workbench& bench) try {
  const Rig& rig = bench.rig();
  if (const auto known = bench.ledger().known_diagnosis(bench.revision(), rig, options.among))
    return {read_diagnosis(*known), true};
  Diagnosis made = make_diagnosis(options, bench);
  lift_time_limit();  // what follows is quick
  if (made.stopped)
    bench.ledger().keep_stopped(bench.revision(), rig, options.among, made);
  else
    bench.ledger().keep(bench.revision(), rig, options.among, made);
  return {std::move(made)};
} catch (const TimeIsUp&) {
  lift_time_limit();
  const Rig& rig = bench.rig();
  Diagnosis nothing =
      stopped_before_search(rig.experiment, *rig.catalog, rig.definition, options.among, "the fit of the model");
  bench.ledger().keep_stopped(bench.revision(), rig, options.among, nothing);
  return {std::move(nothing)};
}

/// An effect that stands for readings of a wrong scale is not what to add.
std::string correction_before_adding(const Rig& rig, const Diagnosis& diagnosis) {
  if (diagnosis.verdict != Verdict::effect_found && diagnosis.verdict != Verdict::not_in_library) return "";
  const std::string lines = scale_correction(rig);
  return lines.empty() ? "" : "under [target.sensors]: " + lines;
}

}  // namespace

void carry_out_diagnosis(DiagnoseOptions options) {
  check_output(options.json);
  check_output_folder(options.out);
  Workbench bench(options);
  options.among = check_among(options.among, bench.rig().experiment, *bench.rig().catalog, bench.rig().definition);
  check_segment(bench.rig().experiment.diagnosis.segment, bench.rig().trials);
  CallPage::allow_new_beginning(options.among.empty() && !has_time_limit());  // without a candidate that ends it
  const auto [diagnosis, known] = find_diagnosis(options, bench);
  CallPage::allow_new_beginning(false);
  if (!takes_standard_output(options.json) && options.task.empty())  // what a task found is read from its plan
    fmt::print("{}{}",
               diagnosis_text(diagnosis, options.experiment.string(), options_to_type(options),
                              correction_before_adding(bench.rig(), diagnosis)),
               known ? "(from the database)\n" : "");
  if (options.json) write_output(*options.json, diagnosis_json(diagnosis));
  if (!options.out.empty()) {
    make_output_folder(options.out);
    const std::string title = fmt::format("{} · revision {}", bench.rig().experiment.name, bench.revision().number);
    draw_diagnosis(diagnosis, title, options.out);
    if (!options.quiet) fmt::print(stderr, "pictures are in {}\n", options.out.string());
  }
  if (diagnosis.stopped) throw TimeIsUp(stopped_by_time_limit() + ". " + diagnosis.stopped->next);
  bench.ledger().done();
}

}  // namespace lacuna
