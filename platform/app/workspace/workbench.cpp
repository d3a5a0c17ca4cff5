#include "app/workspace/workbench.h"

#include "app/terminal/progress_line.h"
#include "app/workspace/integration.h"
#include "data_checks/data_doubts.h"
#include "foundation/processes/interrupt.h"
#include "foundation/parallel.h"
#include "prediction/reading_noise.h"

#include <fmt/format.h>

#include <cstdio>

namespace lacuna {

Workbench::Workbench(const CommonOptions& options) : Workbench(options, open_rig(options)) {
  if (!rig_.left_out.empty()) fmt::print(stderr, "{}\n", rig_.left_out);
  rig_.tell_doubts();
  if (!integration_.empty() && !options.quiet) fmt::print(stderr, "{}\n", integration_);
}

Workbench::Workbench(const CommonOptions& options, Rig rig, Entry entry)
    : options_(options),
      rig_(std::move(rig)),
      seed_(options.seed.value_or(rig_.experiment.seed)),
      threads_(options.threads > 0 ? options.threads : default_threads()),
      integration_(settle_substeps(rig_, rig_.fit_trials(), threads_)),
      ledger_(options, rig_, seed_, threads_) {
  if (entry == Entry::at_once) revision_ = ledger_.enter(rig_);
}

Workbench::Fitted Workbench::fit_model(AtTimeLimit wanted) {
  const std::optional<StoredRevision> stored = revision_ ? revision_ : ledger_.find(rig_);
  if (stored)
    if (std::optional<FitResult> known = ledger_.known_fit(*stored, rig_)) return {std::move(*known), true};
  ledger_.check_kept();
  ProgressLine line(options_.quiet);
  FitResult result = fit({.definition = rig_.definition,
                          .model = *rig_.model,
                          .trials = rig_.trials,
                          .options = rig_.experiment.fit,
                          .seed = seed_,
                          .threads = threads_,
                          .progress = line.callback(),
                          .best_at_time_limit = wanted == AtTimeLimit::best_so_far});
  if (revision_) ledger_.keep(*revision_, rig_, result);
  return {std::move(result), false};
}

Workbench::Compared Workbench::compare_model(const FitResult& fit, bool refitted, bool with_held_out,
                                             bool cross_check) {
  ledger_.check_kept();
  const std::vector<Trial> trials = with_held_out ? rig_.trials : rig_.fit_trials();
  const bool looks = with_held_out && rig_.count(true) > 0;
  const int look = looks ? ledger_.count_look(revision()) : 0;
  const std::unique_ptr<CompiledModel> finer = compile_finer(rig_.definition);
  ProgressLine line(options_.quiet);
  ComparisonTask task{
      .definition = rig_.definition,
      .model = *rig_.model,
      .trials = trials,
      .noise = rig_.experiment.noise,
      .values = fit.parameters(),
      .finer = finer.get(),
      .seed = seed_,
      .threads = threads_,
      .progress = line.callback(),
      .cross_check = cross_check,
      .sensors = noise_of_readings(rig_.definition.structure.robot, TrialPredictor(*rig_.model, rig_.trials, 1))};
  Compared compared{compare(task), look, {}};
  if (revision_) compared.id = keep(trials, compared.result, refitted, looks ? std::optional(look) : std::nullopt);
  return compared;
}

ComparisonId Workbench::keep(const std::vector<Trial>& trials, const Comparison& comparison, bool refitted,
                             std::optional<int> look) {
  return ledger_.keep(revision(), rig_, trials, comparison, refitted, look,
                      rig_.definition.engine.step / rig_.definition.engine.substeps);
}

void Workbench::enter(const Fitted& fitted, const Comparison& comparison, TextReplacement& file) {
  try {
    ledger_.in_one_transaction([&] {
      revision_ = ledger_.enter(rig_);
      if (!fitted.known) ledger_.keep(*revision_, rig_, fitted.result);
      keep(rig_.fit_trials(), comparison, true, std::nullopt);
      file.publish();  // last: only the commit may fail after it
    });
  } catch (...) {
    file.take_back();
    throw;
  }
}

std::vector<Doubt> Workbench::doubts(const FitResult& fit) const {
  const std::vector<double> values = fit.parameters();
  return data_doubts({rig_.definition, *rig_.model, rig_.trials, values});
}

WhereItFails Workbench::where_it_fails(const FitResult& fit, const Comparison& comparison) const {
  return lacuna::where_it_fails({.definition = rig_.definition,
                                 .model = *rig_.model,
                                 .trials = rig_.trials,
                                 .values = fit.parameters(),
                                 .comparison = comparison,
                                 .threads = threads_});
}

namespace {

/// Does what precedes the edit of a file. Ctrl-C and the time limit say that there was none.
RevisionErrors before_edit_of(const std::filesystem::path& file, const std::function<RevisionErrors()>& work) {
  try {
    return work();
  } catch (const Interrupted& interruption) {
    throw Interrupted(std::string(interruption.what()) + "; " + file.string() + " is unchanged");
  }
}

}  // namespace

RevisionErrors errors_before_edit(const CommonOptions& options, Rig rig) {
  return before_edit_of(options.experiment, [&] {
    Workbench bench(options, std::move(rig));
    RevisionErrors errors{bench.revision().number, bench.fit_model().result, {}};
    errors.comparison = bench.compare_model(errors.fit, true, false).result;
    bench.ledger().done();
    return errors;
  });
}

RevisionErrors errors_with_edit(const CommonOptions& options, Rig rig, const std::string& text,
                                const std::string& edited) {
  return before_edit_of(options.experiment, [&]() -> RevisionErrors {
    Workbench bench(options, std::move(rig), Entry::with_its_file);
    const Workbench::Fitted fitted = bench.fit_model();
    const Comparison comparison = bench.compare_model(fitted.result, true, false).result;
    lift_time_limit();
    TextReplacement file(options.experiment, text, edited);
    bench.enter(fitted, comparison, file);
    bench.ledger().done();
    return {bench.revision().number, fitted.result, comparison};
  });
}

}  // namespace lacuna
