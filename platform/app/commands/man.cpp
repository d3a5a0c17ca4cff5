#include "app/commands/commands.h"
#include "app/terminal/output.h"
#include "command_line/manual_page.h"
#include "foundation/text/problem.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace lacuna {
namespace {

struct ManOptions {
  std::vector<std::string> words;
  std::filesystem::path folder;
};

const ManualFrame& frame() {
  static const ManualFrame frame = {
      LACUNA_VERSION,
      "The complete documentation is installed with the program, in share/doc/lacuna; begin with README.md.\n"};
  return frame;
}

void write_all(const std::filesystem::path& folder, const std::vector<CommandFacts>& tree) {
  check_output_folder(folder);
  make_output_folder(folder);
  for (const CommandFacts& command : tree)
    write_output((folder / (manual_name(command) + ".1")).string(), manual_page(command, tree, frame()));
}

void print_one(const std::vector<std::string>& words, const std::vector<CommandFacts>& tree) {
  for (const CommandFacts& command : tree)
    if (command.words == words) return void(std::fputs(manual_page(command, tree, frame()).c_str(), stdout));
  throw_problem({}, fmt::format("man: there is no command \"{}\"; lacuna --help lists them", fmt::join(words, " ")));
}

}  // namespace

void add_man_command(CLI::App& program) {
  auto options = std::make_shared<ManOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("man", "Print the manual page of a command");
  command->add_option("command", options->words, "The command, such as compare or plugins list (default: the program)")
      ->option_text("NAME ...");
  command->add_option("--out", options->folder, "Write the pages of all commands into this folder instead")
      ->option_text("FOLDER");
  command->callback([&program, options] {
    const std::vector<CommandFacts> tree = option_tree(program);
    if (!options->folder.empty()) return write_all(options->folder, tree);
    print_one(options->words, tree);
  });
}

}  // namespace lacuna
