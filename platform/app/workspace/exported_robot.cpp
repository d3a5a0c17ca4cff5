#include "app/workspace/exported_robot.h"

#include "app/terminal/output.h"
#include "app/workspace/exported_model.h"
#include "foundation/text/plain_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <cstdio>

namespace lacuna {
namespace {

/// A robot file that is made, and the one beside it.
struct MadeRobot {
  RobotFileToWrite wanted;
  ExportedRobot exported;
  std::string model;
};

/// Not under the name of something that is read or there, and not over each other.
void check_files(const CommonOptions& options, const RobotExport& wanted) {
  check_new_output(options.json, wanted.existing);
  for (const RobotFileToWrite& one : wanted.files) {
    check_new_output(one.file.string(), wanted.existing);
    check_new_output(one.model_file().string(), wanted.existing);
  }
}

OpenExperiment experiment_to_export(const CommonOptions& options, std::optional<int> revision) {
  OpenExperiment opened = open_experiment(options);
  return revision ? experiment_of_revision(options, std::move(opened), *revision) : std::move(opened);
}

/// The number of the model in the experiment's history; an earlier one does not become the current one by being
/// written.
int revision_number(std::optional<int> asked, ExperimentWorkflow& workflow) {
  if (!asked) return workflow.revision().number;
  const std::optional<StoredRevision> found = workflow.recorder().find(workflow.opened());
  if (found && found->number == *asked) return found->number;
  throw Error(fmt::format(
      "--revision {}: robot, engine or recordings have changed since this revision; restore the files of that time",
      *asked));
}

void print_exported(const MadeRobot& made, const IdentifiedRobot& identified) {
  const ExportedRobot& exported = made.exported;
  fmt::print("{}  {}\n", plain_text(made.wanted.file.string()),
             exported.keeps_original ? "the model's file with the identified values" : "the identified robot");
  for (const IdentifiedRobot::Absorbed& one : identified.absorbed)
    fmt::print("  {} is {} there\n", one.effect, fmt::join(one.addresses, ", "));
  fmt::print(
      "{}  values that this format cannot hold: {}\n", plain_text(made.wanted.model_file().string()),
      exported.set.empty() && identified.effects.empty() && identified.of_setups.empty() && exported.left_out.empty()
          ? "none"
          : "");
  for (const auto& [address, value] : exported.set) fmt::print("  {} = {:.6g}\n", address, value);
  for (const EffectEntry& effect : identified.effects) fmt::print("  effect {}\n", effect.id);
  for (const auto& [address, value] : identified.of_setups)
    fmt::print("  {} = {:.6g}, only for some recordings\n", address, value);
  for (const std::string& sentence : exported.left_out) fmt::print("  left out: {}\n", plain_text(sentence));
}

nlohmann::ordered_json exported_json(const MadeRobot& made, const IdentifiedRobot& identified) {
  nlohmann::ordered_json absorbed = nlohmann::ordered_json::array(), effects = nlohmann::ordered_json::array();
  for (const IdentifiedRobot::Absorbed& one : identified.absorbed)
    absorbed.push_back({{"effect", one.effect}, {"addresses", one.addresses}});
  for (const EffectEntry& effect : identified.effects) effects.push_back(effect.id);
  return {{"format", made.wanted.format},
          {"file", made.wanted.file.string()},
          {"model_file", made.wanted.model_file().string()},
          {"keeps_original", made.exported.keeps_original},
          {"absorbed", absorbed},
          {"set", made.exported.set},
          {"effects", effects},
          {"left_out", made.exported.left_out}};
}

std::vector<MadeRobot> make_robots(const std::vector<RobotFileToWrite>& files, const OpenExperiment& opened,
                                   const IdentifiedRobot& identified, const std::string& comment) {
  const ModelSection& model = opened.experiment.model;
  std::vector<MadeRobot> robots;
  for (const RobotFileToWrite& wanted : files) {
    ExportedRobot exported =
        export_robot(identified.robot, wanted.format, model, comment, wanted.file, *opened.catalog);
    std::string beside =
        exported_model_toml(comment, wanted.file, model, identified, exported, wanted.format != "toml");
    robots.push_back({wanted, std::move(exported), std::move(beside)});
  }
  return robots;
}

}  // namespace

void export_robots(const CommonOptions& options, const RobotExport& wanted) {
  check_files(options, wanted);
  ExperimentWorkflow workflow(options, experiment_to_export(options, wanted.revision),
                              wanted.revision ? Entry::with_its_file : Entry::at_once);
  const int revision = revision_number(wanted.revision, workflow);
  const OpenExperiment& opened = workflow.opened();
  const FitResult fit = opened.definition.free.empty() ? as_written(opened.definition) : workflow.fit_model().result;
  workflow.recorder().done();
  const IdentifiedRobot identified = identified_robot(opened.definition, fit.parameters());
  const std::vector<MadeRobot> robots =
      make_robots(wanted.files, opened, identified, export_comment(opened, revision, fit));
  nlohmann::ordered_json written = nlohmann::ordered_json::array();
  for (const MadeRobot& made : robots) {
    write_output(made.wanted.file.string(), made.exported.text, wanted.existing);
    write_output(made.wanted.model_file().string(), made.model, wanted.existing);
    written.push_back(exported_json(made, identified));
    if (!takes_standard_output(options.json)) print_exported(made, identified);
  }
  const nlohmann::ordered_json all = {
      {"experiment", opened.experiment.name}, {"revision", revision}, {"files", written}};
  if (options.json) write_output(*options.json, all.dump(2) + "\n", wanted.existing);
}

}  // namespace lacuna
