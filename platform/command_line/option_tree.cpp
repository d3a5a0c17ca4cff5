#include "command_line/option_tree.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace lacuna {
namespace {

bool is_file(const std::string& text) {
  for (const char* name : {"FILE", "FILE ...", "FILE...", "DB", "DB...", "SHARD...", "TO"})
    if (text == name) return true;
  return false;
}

OptionValue value_of(const CLI::Option& option) {
  const std::string& text = option.get_option_text();
  if (text == "[=FILE]") return OptionValue::optional_file;
  if (text.empty() && option.get_items_expected_max() == 0) return OptionValue::none;
  if (is_file(text)) return OptionValue::file;
  if (text == "FOLDER") return OptionValue::folder;
  if (text == "N" || text == "NUMBER") return OptionValue::whole_number;
  return text == "MB" ? OptionValue::number : OptionValue::text;
}

OptionFacts facts_of(const CLI::Option& option) {
  const bool positional = !option.nonpositional();
  return {positional || option.get_lnames().empty() ? option.get_name(positional) : option.get_lnames().front(),
          option.get_option_text(),
          option.get_description(),
          value_of(option),
          positional,
          option.get_required(),
          option.get_items_expected_max() > 1,
          option.get_items_expected_max() > 1 && option.get_allow_extra_args()};
}

void add_command(const CLI::App& command, std::vector<std::string> words, std::vector<CommandFacts>& tree) {
  CommandFacts facts{words, command.get_description(), {}, {}};
  for (const CLI::Option* option : command.get_options())
    if (!option->get_group().empty()) facts.options.push_back(facts_of(*option));
  const auto below = command.get_subcommands([](const CLI::App*) { return true; });
  for (const CLI::App* one : below) facts.subcommands.push_back(one->get_name());
  tree.push_back(std::move(facts));
  for (const CLI::App* one : below) {
    std::vector<std::string> longer = words;
    longer.push_back(one->get_name());
    add_command(*one, std::move(longer), tree);
  }
}

}  // namespace

std::vector<CommandFacts> option_tree(const CLI::App& program) {
  std::vector<CommandFacts> tree;
  add_command(program, {}, tree);
  return tree;
}

bool stands_below(const CommandFacts& below, const CommandFacts& command) {
  return below.words.size() == command.words.size() + 1 &&
         std::equal(command.words.begin(), command.words.end(), below.words.begin());
}

}  // namespace lacuna
