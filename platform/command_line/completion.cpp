#include "command_line/completion.h"

#include "foundation/text/problem.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace lacuna {
namespace {

bool is_command(const CommandFacts& command, const std::vector<std::string>& words) { return command.words == words; }

}  // namespace

std::vector<std::string> completed_shells() { return {"bash", "fish", "zsh"}; }

Offered offered_for(const CommandFacts& command, const OptionFacts& option) {
  if ((is_command(command, {"help"}) || is_command(command, {"man"})) && option.positional) return Offered::commands;
  if (is_command(command, {"completion"}) && option.positional) return Offered::shells;
  if (is_command(command, {"add"}) && option.name == "effect") return Offered::effects;
  if (is_command(command, {"diagnose"}) && option.name == "among") return Offered::effects;
  if (is_command(command, {"plugins", "show"}) && option.name == "name") return Offered::plugins;
  if (is_command(command, {"plugins", "list"}) && option.name == "kind") return Offered::kinds;
  if (is_command(command, {"sql"}) && option.name == "sql") return Offered::queries;
  if (is_command(command, {"export"}) && option.name == "what") return Offered::rows;
  switch (option.value) {
    case OptionValue::file:
    case OptionValue::optional_file: return Offered::files;
    case OptionValue::folder: return Offered::folders;
    default: return Offered::nothing;
  }
}

std::string question_for(Offered offered) {
  // Columns of `plugins list`: kind, name and summary, with two spaces or more between them.
  const std::string components = "lacuna plugins list 2>/dev/null | sed -E 's/ {2,}/\\t/g'";
  switch (offered) {
    case Offered::effects:
      return "lacuna plugins list --kind effect 2>/dev/null | sed -E 's/ {2,}/\\t/g' | cut -f2; echo wrong_value";
    case Offered::plugins: return components + " | cut -f2 | sort -u";
    case Offered::kinds: return components + " | cut -f1 | sort -u";
    case Offered::rows:
      return "lacuna sql --views 2>/dev/null | sed -n -E 's/^([a-z_0-9]+)$/\\1/p'; for word do case $word in *.db) "
             "lacuna sql \"$word\" --csv \"SELECT DISTINCT trial FROM traces\" 2>/dev/null | tail -n +2 ;; esac; done";
    case Offered::queries: return "lacuna sql --views 2>/dev/null | sed -n -E 's/^([a-z_0-9]+)$/SELECT * FROM \\1/p'";
    default: return "";
  }
}

std::string completion_script(const std::string& shell, const std::vector<CommandFacts>& tree) {
  if (shell == "bash") return bash_completion(tree);
  if (shell == "fish") return fish_completion(tree);
  if (shell == "zsh") return zsh_completion(tree);
  throw_problem({}, fmt::format("completion: there is no script for \"{}\"{}; there are scripts for {}", shell,
                                did_you_mean(shell, completed_shells()), fmt::join(completed_shells(), ", ")));
}

}  // namespace lacuna
