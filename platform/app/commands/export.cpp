#include "app/commands/commands.h"
#include "app/terminal/output.h"
#include "app/workspace/exported_model.h"
#include "foundation/plain_text.h"
#include "foundation/problem.h"
#include "foundation/shell_word.h"
#include "foundation/unit.h"

#include <lacuna/robot_format.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace lacuna {
namespace {

struct ExportOptions : CommonOptions {
  std::optional<std::string> urdf, mjcf, toml;
  std::optional<int> revision;
};

/// A file to write, and the plugin that writes it.
struct WantedFile {
  std::string format;
  std::filesystem::path file;

  std::filesystem::path model_file() const { return file.parent_path() / (file.stem().string() + ".model.toml"); }
};

std::vector<WantedFile> wanted_files(const ExportOptions& options) {
  std::vector<WantedFile> files;
  if (options.urdf) files.push_back({"urdf", *options.urdf});
  if (options.mjcf) files.push_back({"mjcf", *options.mjcf});
  if (options.toml) files.push_back({"toml", *options.toml});
  if (files.empty()) throw_problem({}, "say what to write: --toml robot.toml, --urdf robot.urdf, --mjcf robot.xml");
  return files;
}

/// Not under the name of something that is read, and not over each other.
void check_wanted(const std::vector<WantedFile>& files) {
  for (const WantedFile& wanted : files) {
    check_output(wanted.file.string());
    check_output(wanted.model_file().string());
  }
}

Rig rig_to_export(const ExportOptions& options) {
  Rig rig = open_rig(options);
  return options.revision ? rig_of_revision(options, std::move(rig), *options.revision) : std::move(rig);
}

/// The number of the model in the experiment's history; an earlier one does not become the current one by being
/// written.
int revision_number(const ExportOptions& options, Workbench& bench) {
  if (!options.revision) return bench.revision().number;
  const std::optional<StoredRevision> found = bench.ledger().find(bench.rig());
  if (found && found->number == *options.revision) return found->number;
  throw Error(
      fmt::format("--revision {}: its robot, engine or recordings were others than the experiment has now; take "
                  "the files back as they were then",
                  *options.revision));
}

void print_exported(const WantedFile& wanted, const IdentifiedRobot& identified, const ExportedRobot& exported) {
  fmt::print("{}  {}\n", plain_text(wanted.file.string()),
             exported.keeps_original ? "the model's file with the identified values" : "the identified robot");
  for (const IdentifiedRobot::Absorbed& one : identified.absorbed)
    fmt::print("  {} is {} there\n", one.effect, fmt::join(one.addresses, ", "));
  fmt::print(
      "{}  what that file has no place for: {}\n", plain_text(wanted.model_file().string()),
      exported.set.empty() && identified.effects.empty() && identified.of_setups.empty() && exported.left_out.empty()
          ? "nothing"
          : "");
  for (const auto& [address, value] : exported.set) fmt::print("  {} = {:.6g}\n", address, value);
  for (const EffectEntry& effect : identified.effects) fmt::print("  effect {}\n", effect.id);
  for (const auto& [address, value] : identified.of_setups)
    fmt::print("  {} = {:.6g}, of some recordings alone\n", address, value);
  for (const std::string& sentence : exported.left_out) fmt::print("  left out: {}\n", plain_text(sentence));
}

nlohmann::ordered_json exported_json(const WantedFile& wanted, const IdentifiedRobot& identified,
                                     const ExportedRobot& exported) {
  nlohmann::ordered_json absorbed = nlohmann::ordered_json::array(), effects = nlohmann::ordered_json::array();
  for (const IdentifiedRobot::Absorbed& one : identified.absorbed)
    absorbed.push_back({{"effect", one.effect}, {"addresses", one.addresses}});
  for (const EffectEntry& effect : identified.effects) effects.push_back(effect.id);
  return {{"format", wanted.format},
          {"file", wanted.file.string()},
          {"model_file", wanted.model_file().string()},
          {"keeps_original", exported.keeps_original},
          {"absorbed", absorbed},
          {"set", exported.set},
          {"effects", effects},
          {"left_out", exported.left_out}};
}

void run_export(const ExportOptions& options) {
  check_output(options.json);
  const std::vector<WantedFile> files = wanted_files(options);
  check_wanted(files);
  Workbench bench(options, rig_to_export(options), options.revision ? Entry::with_its_file : Entry::at_once);
  const int revision = revision_number(options, bench);
  const FitResult fit =
      bench.rig().definition.free.empty() ? as_written(bench.rig().definition) : bench.fit_model().result;
  bench.ledger().done();
  const IdentifiedRobot identified = identified_robot(bench.rig().definition, fit.parameters());
  const std::string comment = export_comment(bench.rig(), revision, fit);
  const ModelSection& model = bench.rig().experiment.model;
  nlohmann::ordered_json written = nlohmann::ordered_json::array();
  for (const WantedFile& wanted : files) {
    const ExportedRobot exported =
        export_robot(identified.robot, wanted.format, model, comment, wanted.file, *bench.rig().catalog);
    write_output(wanted.file.string(), exported.text);
    write_output(wanted.model_file().string(),
                 exported_model_toml(comment, wanted.file, model, identified, exported, wanted.format != "toml"));
    written.push_back(exported_json(wanted, identified, exported));
    if (!takes_standard_output(options.json)) print_exported(wanted, identified, exported);
  }
  if (options.json)
    write_output(
        *options.json,
        nlohmann::ordered_json{{"experiment", bench.rig().experiment.name}, {"revision", revision}, {"files", written}}
                .dump(2) +
            "\n");
}

}  // namespace

void add_export_command(CLI::App& program) {
  auto options = std::make_shared<ExportOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("export", "Write the identified robot as TOML, URDF or MJCF");
  add_experiment_options(*command, *options);
  command->add_option("--urdf", options->urdf, "URDF file to write")->option_text("FILE");
  command->add_option("--mjcf", options->mjcf, "MJCF file to write")->option_text("FILE");
  command->add_option("--toml", options->toml, "Robot file to write (TOML)")->option_text("FILE");
  command->add_option("--revision", options->revision, "Revision of the experiment, instead of the one it is at now")
      ->option_text("N");
  add_work_options(*command, *options);
  command->callback([options] { run_export(*options); });
}

}  // namespace lacuna
