#include "app/commands.h"
#include "app/options.h"
#include "config/experiment_reader.h"
#include "evaluation/model_definition.h"

#include <cstdio>
#include <memory>

namespace lacuna {

void add_check_command(CLI::App& program) {
  auto options = std::make_shared<CommonOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("check", "Check an experiment file and everything it names");
  add_experiment_options(*command, *options);
  command->callback([options] {
    const Experiment experiment = read_experiment(options->experiment, options->overrides);
    const PluginCatalog catalog(plugin_search_path(options->plugin_paths));
    define_model(experiment, catalog);
    std::printf("%s: ok\n", options->experiment.string().c_str());
  });
}

}  // namespace lacuna
