#include "app/workspace/experiment_workflow.h"

#include "app/terminal/progress_line.h"
#include "app/workspace/integration.h"
#include "data_checks/data_checks.h"
#include "prediction/reading_noise.h"

#include <fmt/format.h>

#include <cstdio>

namespace lacuna {

ExperimentWorkflow::ExperimentWorkflow(const CommonOptions& options)
    : ExperimentWorkflow(options, open_experiment(options)) {
  if (!opened_.left_out.empty()) fmt::print(stderr, "{}\n", opened_.left_out);
  opened_.tell_doubts();
  if (!integration_.empty() && !options.quiet) fmt::print(stderr, "{}\n", integration_);
}

ExperimentWorkflow::ExperimentWorkflow(const CommonOptions& options, OpenExperiment opened, Entry entry)
    : options_(options),
      opened_(std::move(opened)),
      seed_(options.seed.value_or(opened_.experiment.seed)),
      integration_(settle_substeps(opened_, opened_.fit_trials(), work())),
      recorder_(options, opened_, seed_, work().threads) {
  if (entry == Entry::at_once) revision_ = recorder_.enter(opened_);
}

ExperimentWorkflow::Fitted ExperimentWorkflow::fit_model(AtTimeLimit wanted) {
  const std::optional<StoredRevision> stored = revision_ ? revision_ : recorder_.find(opened_);
  if (stored)
    if (std::optional<FitResult> known = recorder_.known_fit(*stored, opened_)) return {std::move(*known), true};
  recorder_.check_kept();
  ProgressLine line(options_.quiet);
  FitResult result = fit({.definition = opened_.definition,
                          .model = *opened_.model,
                          .trials = opened_.trials,
                          .options = opened_.experiment.fit,
                          .seed = seed_,
                          .work = work(line.callback()),
                          .best_at_time_limit = wanted == AtTimeLimit::best_so_far});
  if (revision_) recorder_.keep(*revision_, opened_, result);
  return {std::move(result), false};
}

ExperimentWorkflow::Compared ExperimentWorkflow::compare_model(const FitResult& fit, bool refitted, bool with_held_out,
                                                               bool cross_check) {
  recorder_.check_kept();
  const std::vector<Trial> trials = with_held_out ? opened_.trials : opened_.fit_trials();
  const bool looks = with_held_out && opened_.count(true) > 0;
  const int look = looks ? recorder_.count_look(revision()) : 0;
  const std::unique_ptr<CompiledModel> finer = compile_finer(opened_.definition);
  ProgressLine line(options_.quiet);
  ComparisonTask task{.definition = opened_.definition,
                      .model = *opened_.model,
                      .trials = trials,
                      .noise = opened_.experiment.noise,
                      .values = fit.parameters(),
                      .finer = finer.get(),
                      .seed = seed_,
                      .work = work(line.callback()),
                      .cross_check = cross_check,
                      .sensors = noise_of_readings(opened_.definition.structure.robot,
                                                   TrialPredictor(*opened_.model, opened_.trials, {1, options_.stop}))};
  Compared compared{compare(task), look, {}};
  if (revision_) compared.id = keep(trials, compared.result, refitted, looks ? std::optional(look) : std::nullopt);
  return compared;
}

ComparisonId ExperimentWorkflow::keep(const std::vector<Trial>& trials, const Comparison& comparison, bool refitted,
                                      std::optional<int> look) {
  return recorder_.keep(revision(), opened_, trials, comparison, refitted, look,
                        opened_.definition.engine.step / opened_.definition.engine.substeps);
}

void ExperimentWorkflow::enter(const Fitted& fitted, const Comparison& comparison, TextReplacement& file) {
  try {
    recorder_.in_one_transaction([&] {
      revision_ = recorder_.enter(opened_);
      if (!fitted.known) recorder_.keep(*revision_, opened_, fitted.result);
      keep(opened_.fit_trials(), comparison, true, std::nullopt);
      file.publish();  // last: only the commit may fail after it
    });
  } catch (...) {
    file.take_back();
    throw;
  }
}

std::vector<DataWarning> ExperimentWorkflow::doubts(const FitResult& fit) const {
  const std::vector<double> values = fit.parameters();
  return data_checks({opened_.definition, *opened_.model, opened_.trials, values, false, options_.stop});
}

WhereItFails ExperimentWorkflow::where_it_fails(const FitResult& fit, const Comparison& comparison) const {
  return lacuna::where_it_fails({.definition = opened_.definition,
                                 .model = *opened_.model,
                                 .trials = opened_.trials,
                                 .values = fit.parameters(),
                                 .comparison = comparison,
                                 .work = work()});
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

RevisionErrors errors_before_edit(const CommonOptions& options, OpenExperiment opened) {
  return before_edit_of(options.experiment, [&] {
    ExperimentWorkflow workflow(options, std::move(opened));
    RevisionErrors errors{workflow.revision().number, workflow.fit_model().result, {}};
    errors.comparison = workflow.compare_model(errors.fit, true, false).result;
    workflow.recorder().done();
    return errors;
  });
}

RevisionErrors errors_with_edit(const CommonOptions& options, OpenExperiment opened, const std::string& text,
                                const std::string& edited) {
  return before_edit_of(options.experiment, [&]() -> RevisionErrors {
    ExperimentWorkflow workflow(options, std::move(opened), Entry::with_its_file);
    const ExperimentWorkflow::Fitted fitted = workflow.fit_model();
    const Comparison comparison = workflow.compare_model(fitted.result, true, false).result;
    options.stop.lift_limit();
    TextReplacement file(options.experiment, text, edited);
    workflow.enter(fitted, comparison, file);
    workflow.recorder().done();
    return {workflow.revision().number, fitted.result, comparison};
  });
}

}  // namespace lacuna
