#include "app/commands/commands.h"
#include "app/runs/run_summary.h"
#include "app/terminal/options.h"
#include "app/terminal/output.h"
#include "app/workspace/check_json.h"
#include "app/workspace/check_summary.h"
#include "app/workspace/open_experiment.h"
#include "app/workspace/scale_note.h"
#include "config/file_references.h"
#include "evaluation/prediction/trial_predictor.h"
#include "fitting/floor/disturbance.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

namespace lacuna {
namespace {

struct CheckOptions : CommonOptions {
  std::string reference;
};

std::string joined(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); }

/// What a fit, a comparison or a diagnosis would stop at before it simulates anything.
std::vector<Problem> obstacles(const CheckOptions& options, const OpenExperiment& opened) {
  const SourceLocation file{options.experiment.string(), 0, 0};
  std::vector<Problem> problems;
  if (opened.count(false) == 0)
    problems.push_back({file, "every trial is held out; name at least one fit file under target.files"});
  try {
    const TrialPredictor every_trial_suits_the_model(*opened.model, opened.trials, {1});
    disturbed_joints(opened.definition.structure.robot, opened.experiment.noise);
  } catch (const Error& error) {
    problems.push_back({file, error.what()});
  }
  return problems;
}

/// What plugins of the model's effects do and should not.
void note_remarks(OpenExperiment& opened) {
  const std::vector<EffectEntry>& effects = opened.experiment.model.effects;
  for (std::size_t i = 0; i < effects.size(); ++i)
    if (const std::string remark = opened.catalog->remark_on_effect(effects[i].effect); !remark.empty())
      opened.notes.push_back({opened.experiment.where(fmt::format("model.effects[{}].effect", i)), remark});
}

void check(const CheckOptions& options) {
  if (!options.reference.empty()) {
    std::fputs(file_reference(options.reference).c_str(), stdout);
    return;
  }
  check_output(options.json);
  OpenExperiment opened = open_experiment(options);
  const bool recorded = opened.experiment.target.kind == "recorded";
  if (recorded)
    if (std::vector<Problem> found = obstacles(options, opened); !found.empty()) throw BadInput(std::move(found));
  if (recorded)
    if (std::optional<ReadingNote> scale = scale_note(opened)) opened.notes.push_back(std::move(*scale));
  if (!opened.left_out.empty()) opened.notes.push_back({opened.experiment.where("target.version"), opened.left_out});
  note_remarks(opened);
  const std::string summary = check_summary(opened.experiment, opened.definition, opened.trials, opened.notes);
  const std::string json = options.json ? check_json(opened, database_of(options, opened.experiment).string()) : "";
  const std::string of_run = recorded ? "" : run_summary(OpenEeaRun(std::move(opened)));
  if (!takes_standard_output(options.json)) fmt::print("{}: ok\n{}{}", options.experiment.string(), summary, of_run);
  if (options.json) write_output(*options.json, json);
}

}  // namespace

void add_check_command(CLI::App& program) {
  auto options = std::make_shared<CheckOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command =
      program.add_subcommand("check", "Check an experiment file and all files and plugins that it names");
  add_experiment_options(*command, *options);
  CLI::Option* reference =
      command
          ->add_option("--print-reference", options->reference,
                       "Check nothing; print the reference of all keys of an experiment or robot file: " +
                           joined(file_reference_names()))
          ->option_text("NAME")
          ->check(CLI::IsMember(file_reference_names()));
  add_result_option(*command, "json", options->json, "Write results as JSON to FILE (default: standard output)");
  CLI::Option* experiment = command->get_option("experiment");
  experiment->required(false)->excludes(reference);
  command->callback([options, experiment, reference] {
    if (experiment->count() + reference->count() == 0) throw CLI::RequiredError(experiment->get_name());
    check(*options);
  });
}

}  // namespace lacuna
