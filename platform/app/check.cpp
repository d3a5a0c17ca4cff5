#include "app/check_summary.h"
#include "app/commands.h"
#include "app/options.h"
#include "config/experiment_reader.h"
#include "config/file_references.h"
#include "evaluation/model_definition.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>

namespace lacuna {
namespace {

struct CheckOptions : CommonOptions {
  std::string reference;
};

void check(const CheckOptions& options) {
  if (!options.reference.empty()) {
    std::fputs(file_reference(options.reference).c_str(), stdout);
    return;
  }
  const Experiment experiment = read_experiment(options.experiment, options.overrides);
  const PluginCatalog catalog(plugin_search_path(options.plugin_paths));
  const ModelDefinition definition = define_model(experiment, catalog);
  const Recording recording = read_recording(experiment.target.recording, definition.structure.robot);
  std::printf("%s: ok\n%s", options.experiment.string().c_str(),
              check_summary(experiment, definition, recording).c_str());
}

}  // namespace

void add_check_command(CLI::App& program) {
  auto options = std::make_shared<CheckOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("check", "Check an experiment file and everything it names");
  add_experiment_options(*command, *options);
  CLI::Option* reference =
      command->add_option("--print-reference", options->reference, "Print a reference of file keys instead")
          ->check(CLI::IsMember(file_reference_names()));
  CLI::Option* experiment = command->get_option("experiment");
  experiment->required(false)->excludes(reference);
  command->callback([options, experiment, reference] {
    if (experiment->count() + reference->count() == 0) throw CLI::RequiredError(experiment->get_name());
    check(*options);
  });
}

}  // namespace lacuna
