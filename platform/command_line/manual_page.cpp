#include "command_line/manual_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace lacuna {
namespace {

/// Text of a line that is no request, with hyphens that can be typed.
std::string roff_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\\')
      escaped += "\\e";
    else if (c == '-')
      escaped += "\\-";
    else
      escaped += c;
  }
  if (escaped.starts_with('.') || escaped.starts_with('\'')) escaped.insert(0, "\\&");
  return escaped;
}

std::string command_line_of(const CommandFacts& command) {
  return command.words.empty() ? "lacuna" : fmt::format("lacuna {}", fmt::join(command.words, " "));
}

std::string value_text(const OptionFacts& option) {
  if (option.value == OptionValue::none) return "";
  if (option.value == OptionValue::optional_file) return "[=FILE]";
  return " " + (option.text.empty() ? "VALUE" : option.text);
}

std::string synopsis(const CommandFacts& command) {
  std::string line = fmt::format(".B {}\n[OPTIONS]", roff_text(command_line_of(command)));
  if (!command.subcommands.empty()) line += " COMMAND";
  for (const OptionFacts& option : command.options) {
    if (!option.positional) continue;
    const std::string name = option.name + (option.repeats ? "..." : "");
    line += " " + roff_text(option.required ? name : "[" + name + "]");
  }
  return line + "\n";
}

std::string entries(const CommandFacts& command, bool positional) {
  std::string text;
  for (const OptionFacts& option : command.options)
    if (option.positional == positional)
      text += fmt::format(
          ".TP\n.B {}\n{}\n",
          roff_text(positional ? option.name + value_text(option) : "--" + option.name + value_text(option)),
          roff_text(option.description));
  return text;
}

std::string section(const std::string& name, const std::string& text) {
  return text.empty() ? "" : ".SH " + name + "\n" + text;
}

std::string commands(const CommandFacts& command, const std::vector<CommandFacts>& tree) {
  std::string text;
  for (const CommandFacts& below : tree)
    if (stands_below(below, command))
      text += fmt::format(".TP\n.BR {} (1)\n{}\n", roff_text(manual_name(below)), roff_text(below.description));
  return text;
}

constexpr const char* kExitCodes =
    "0 done, 1 failed, 2 bad input, 75 interrupted: run the command again (lacuna run: with --resume).\n";

}  // namespace

std::string manual_name(const CommandFacts& command) {
  return command.words.empty() ? "lacuna" : fmt::format("lacuna-{}", fmt::join(command.words, "-"));
}

std::string manual_page(const CommandFacts& command, const std::vector<CommandFacts>& tree, const ManualFrame& frame) {
  std::string name = manual_name(command), title = name;
  std::transform(title.begin(), title.end(), title.begin(), [](char c) { return c >= 'a' && c <= 'z' ? c - 32 : c; });
  std::string page = fmt::format(".TH {} 1 \"\" \"lacuna {}\" \"User Commands\"\n", roff_text(title), frame.version);
  page += section("NAME", fmt::format("{} \\- {}\n", roff_text(name), roff_text(command.description)));
  page += section("SYNOPSIS", synopsis(command));
  page += section("ARGUMENTS", entries(command, true));
  page += section("OPTIONS", entries(command, false));
  page += section("COMMANDS", commands(command, tree));
  page += section("EXIT STATUS", kExitCodes);
  if (command.words.empty()) return page + section("NOTES", roff_text(frame.notes));
  return page + section("SEE ALSO", ".BR lacuna (1)\n");
}

}  // namespace lacuna
