#include "app/commands/commands.h"
#include "app/runs/run_summary.h"
#include "app/terminal/options.h"
#include "app/terminal/output.h"
#include "app/workspace/check_json.h"
#include "app/workspace/check_summary.h"
#include "app/workspace/rig.h"
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
std::vector<Problem> obstacles(const CheckOptions& options, const Rig& rig) {
  const SourceLocation file{options.experiment.string(), 0, 0};
  std::vector<Problem> problems;
  if (rig.count(false) == 0)
    problems.push_back({file, "every trial is held out; name at least one fit file under target.files"});
  try {
    const TrialPredictor every_trial_suits_the_model(*rig.model, rig.trials, 1);
    disturbed_joints(rig.definition.structure.robot, rig.experiment.noise);
  } catch (const Error& error) {
    problems.push_back({file, error.what()});
  }
  return problems;
}

/// What plugins of the model's effects do and should not.
void note_remarks(Rig& rig) {
  const std::vector<EffectEntry>& effects = rig.experiment.model.effects;
  for (std::size_t i = 0; i < effects.size(); ++i)
    if (const std::string remark = rig.catalog->remark_on_effect(effects[i].effect); !remark.empty())
      rig.notes.push_back({rig.experiment.where(fmt::format("model.effects[{}].effect", i)), remark});
}

void check(const CheckOptions& options) {
  if (!options.reference.empty()) {
    std::fputs(file_reference(options.reference).c_str(), stdout);
    return;
  }
  check_output(options.json);
  Rig rig = open_rig(options);
  const bool recorded = rig.experiment.target.kind == "recorded";
  if (recorded)
    if (std::vector<Problem> found = obstacles(options, rig); !found.empty()) throw BadInput(std::move(found));
  if (recorded)
    if (std::optional<ReadingNote> scale = scale_note(rig)) rig.notes.push_back(std::move(*scale));
  if (!rig.left_out.empty()) rig.notes.push_back({rig.experiment.where("target.version"), rig.left_out});
  note_remarks(rig);
  const std::string summary = check_summary(rig.experiment, rig.definition, rig.trials, rig.notes);
  const std::string json = options.json ? check_json(rig, database_of(options, rig.experiment).string()) : "";
  const std::string of_run = recorded ? "" : run_summary(EeaBench(std::move(rig)));
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
                       "Print a reference of the file's keys instead: " + joined(file_reference_names()))
          ->option_text("NAME")
          ->check(CLI::IsMember(file_reference_names()));
  add_result_option(*command, "json", options->json, "Results as JSON, to standard output or FILE");
  CLI::Option* experiment = command->get_option("experiment");
  experiment->required(false)->excludes(reference);
  command->callback([options, experiment, reference] {
    if (experiment->count() + reference->count() == 0) throw CLI::RequiredError(experiment->get_name());
    check(*options);
  });
}

}  // namespace lacuna
