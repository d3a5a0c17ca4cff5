#include "command_line/completion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace lacuna {
namespace {

constexpr const char* kZshBegin = R"sh(#compdef lacuna
# zsh completion for lacuna, made by: lacuna completion zsh
# As the file _lacuna in a folder of $fpath, or for this shell: source <(lacuna completion zsh)

_lacuna_ask() {  # a command line that prints one name a line
  local answer
  answer=$(sh -c $1 sh $words)
  local -a names
  names=("${(@f)answer}")
  compadd "$@[2,-1]" -a names
}
)sh";

constexpr const char* kZshEnd = R"sh(
if [ "$funcstack[1]" = "_lacuna" ]; then
  _lacuna "$@"
else
  compdef _lacuna lacuna
fi
)sh";

/// In single quotes.
std::string zsh_word(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

/// A text within a specification of `_arguments`, where these characters have a meaning.
std::string zsh_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string zsh_action(Offered offered, const CommandFacts& program) {
  switch (offered) {
    case Offered::nothing: return " ";
    case Offered::files: return "_files";
    case Offered::folders: return "_files -/";
    case Offered::commands: return fmt::format("({})", fmt::join(program.subcommands, " "));
    case Offered::shells: return fmt::format("({})", fmt::join(completed_shells(), " "));
    default: return fmt::format("_lacuna_names_{}", static_cast<int>(offered));
  }
}

std::string zsh_argument(const CommandFacts& command, const OptionFacts& option, const CommandFacts& program) {
  const std::string action = zsh_action(offered_for(command, option), program);
  const std::string value = fmt::format("{}:{}", zsh_text(option.text.empty() ? option.name : option.text), action);
  const std::string repeats = option.repeats ? "*" : "";
  if (option.positional) return (option.repeats ? "*:" : option.required ? ":" : "::") + value;
  const std::string name = "--" + option.name, description = "[" + zsh_text(option.description) + "]";
  if (option.value == OptionValue::none) return repeats + name + description;
  if (option.value == OptionValue::optional_file) return name + "=-" + description + "::FILE:" + action;
  return repeats + name + "=" + description + ":" + value;
}

std::string function_name(const CommandFacts& command) {
  return command.words.empty() ? "_lacuna" : fmt::format("_lacuna_{}", fmt::join(command.words, "_"));
}

/// One function for each of what the program is asked, for a question would need quoting within quotes.
std::string zsh_questions() {
  std::string functions;
  for (const Offered offered : {Offered::effects, Offered::plugins, Offered::kinds, Offered::rows, Offered::queries})
    functions += fmt::format("_lacuna_names_{}() {{ _lacuna_ask {} }}\n", static_cast<int>(offered),
                             zsh_word(question_for(offered)));
  return functions;
}

std::string zsh_subcommands(const CommandFacts& command, const std::vector<CommandFacts>& tree) {
  std::string names, cases;
  for (const CommandFacts& below : tree) {
    if (!stands_below(below, command)) continue;
    names += " " + zsh_word(below.words.back() + ":" + zsh_text(below.description));
    cases += fmt::format("        {}) {} ;;\n", below.words.back(), function_name(below));
  }
  return "  case $state in\n    command)\n      local -a names=(" + names +
         " )\n      _describe command names ;;\n    rest)\n      case $line[1] in\n" + cases +
         "      esac ;;\n  esac\n";
}

}  // namespace

std::string zsh_completion(const std::vector<CommandFacts>& tree) {
  std::string script = kZshBegin + zsh_questions();
  for (const CommandFacts& command : tree) {
    const bool is_group = !command.subcommands.empty();
    script += fmt::format("\n{}() {{\n  local context state line\n  _arguments -C", function_name(command));
    for (const OptionFacts& option : command.options)
      script += " \\\n    " + zsh_word(zsh_argument(command, option, tree.front()));
    if (is_group) script += " \\\n    '1: :->command' '*:: :->rest'";
    script += "\n";
    if (is_group) script += zsh_subcommands(command, tree);
    script += "}\n";
  }
  return script + kZshEnd;
}

}  // namespace lacuna
