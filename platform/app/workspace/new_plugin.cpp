#include "app/workspace/new_plugin.h"

#include "app/terminal/options.h"
#include "app/workspace/new_effect.h"
#include "app/workspace/plugin_folder.h"
#include "foundation/text/counted.h"
#include "formula/effect_source.h"
#include "plugin_drafts/plugin_draft.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace lacuna {
namespace {

struct NewPluginOptions {
  CommonOptions common;
  std::string name;
  std::filesystem::path into = ".";
};

void make_plugin(const DraftKind& kind, const NewPluginOptions& options) {
  const NewPlugin plugin = {kind.noun, options.name, options.into, options.common.plugin_paths};
  ProblemList problems;
  check_plugin_name(plugin, problems);
  problems.throw_if_any();
  const std::filesystem::path folder = write_plugin_folder(plugin, plugin_draft(kind.noun, options.name));
  fmt::print("{} written: {}\n", folder.string(), kind.does);
  std::string use = filled(kind.use, {{"NAME", options.name}});
  std::erase(use, '`');
  print_next_steps(folder, "in an experiment: " + use + "; add @PATH@ to commands");
}

/// "robot format" as it is typed.
std::string command_word(std::string noun) {
  std::replace(noun.begin(), noun.end(), ' ', '-');
  return noun;
}

void add_kind(CLI::App& made, const DraftKind& kind) {
  auto options = std::make_shared<NewPluginOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = made.add_subcommand(command_word(kind.noun),
                                          "Write " + with_article(kind.noun) + " plugin. Example: " + kind.does);
  command->add_option("name", options->name, "Name of the plugin and of its folder")->required()->option_text("NAME");
  command
      ->add_option("--into", options->into, "Folder in which the plugin's folder is made (default: the current folder)")
      ->option_text("FOLDER");
  add_plugin_path_option(*command, options->common);
  command->callback([options, kind] { make_plugin(kind, *options); });
}

}  // namespace

void add_new_plugin_command(CLI::App& plugins) {
  CLI::App* made = plugins.add_subcommand("new", "Write a working plugin to start from: source, project and test");
  made->require_subcommand(1);
  add_new_effect_command(*made);
  for (const DraftKind& kind : draft_kinds()) add_kind(*made, kind);
}

}  // namespace lacuna
