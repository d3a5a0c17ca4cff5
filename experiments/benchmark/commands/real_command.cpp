#include "commands/commands.h"
#include "commands/lacuna_program.h"
#include "commands/not_empty.h"

#include "foundation/processes/interrupt.h"
#include "measured_rigs/rig_results.h"
#include "runs/case_failure.h"
#include "runs/work_folder.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <utility>

namespace hidden_effects {
namespace {

namespace fs = std::filesystem;

struct RealOptions {
  fs::path rigs, answers, work, lacuna;
  std::vector<std::string> only;
  int longest = 1800;
};

/// Experiments and robots, but no databases; files that are there stay, with what was found by them.
void copy_rigs(const fs::path& from, const fs::path& to) {
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(from)) {
    if (entry.path().extension() != ".toml") continue;
    const fs::path target = to / fs::relative(entry.path(), from);
    make_folder(target.parent_path());
    fs::copy_file(entry.path(), target, fs::copy_options::overwrite_existing);
  }
}

void run(const RealOptions& options) {
  if (!std::getenv("LACUNA_DATA"))
    throw std::invalid_argument("LACUNA_DATA names no folder: set it to the one that has the recordings");
  for (const auto& [option, path] : {std::pair{"--rigs", options.rigs}, std::pair{"--answers", options.answers}})
    if (!fs::exists(path)) throw std::invalid_argument(fmt::format("{} {}: is not there", option, path.string()));
  const std::vector<AcceptedAnswer> answers = read_accepted_answers(options.answers);
  for (const std::string& name : options.only)
    if (std::none_of(answers.begin(), answers.end(), [&](const AcceptedAnswer& one) { return one.rig == name; }))
      throw std::invalid_argument(fmt::format("--only {}: {} has no such rig", name, options.answers.string()));
  const WorkFolder work(options.work);
  const ProgramSettings settings = program_settings(options.lacuna, options.longest);
  const std::string identity = identity_of(settings, work.path());
  copy_rigs(options.rigs, work.path());
  std::vector<RigResult> results;
  for (const AcceptedAnswer& accepted : answers) {
    if (!options.only.empty() &&
        std::find(options.only.begin(), options.only.end(), accepted.rig) == options.only.end())
      continue;
    std::vector<std::string> experiments = accepted.experiments;
    experiments.insert(experiments.end(), accepted.nothing_missing.begin(), accepted.nothing_missing.end());
    for (const std::string& experiment : experiments) {
      fmt::print(stderr, "{} ...\n", experiment);
      try {
        results.push_back(run_rig(accepted, experiment, work.path(), settings, identity));
      } catch (const CaseStopped&) {
        throw lacuna::Interrupted("interrupted; run the same command again to go on");
      }
    }
  }
  fmt::print("{}", table_of(results));
}

}  // namespace

void add_real_command(CLI::App& program) {
  auto options = std::make_shared<RealOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command =
      program.add_subcommand("real", "Diagnoses of measured rigs against answers that were fixed beforehand");
  const auto add = [&](const char* name, auto& value, const char* text, const char* type) {
    return command->add_option(name, value, text)->check(not_empty())->option_text(type);
  };
  add("--rigs", options->rigs, "Folder with the experiments", "FOLDER")->required();
  add("--answers", options->answers, "The accepted answers (TOML)", "FILE")->required();
  add("--work", options->work, "Folder for databases and results; a second call goes on there", "FOLDER")->required();
  add("--only", options->only, "Names of rigs (default: all)", "RIG...");
  add("--lacuna", options->lacuna, "The program (default: beside this one)", "FILE");
  command->add_option("--longest", options->longest, "Seconds of one diagnosis (default: 1800)")->option_text("N");
  command->callback([options] { run(*options); });
}

}  // namespace hidden_effects
