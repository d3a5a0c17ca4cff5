#include "command_line/completion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace lacuna {
namespace {

constexpr const char* kFishBegin = R"sh(# fish completion for lacuna, made by: lacuna completion fish
# For this shell: lacuna completion fish | source

# Whether the words so far begin with these commands.
function __lacuna_at
    set -l words (commandline -opc | string match -v -- '-*')[2..-1]
    set -l depth (count $argv)
    test (count $words) -ge $depth; and test "$words[1..$depth]" = "$argv"
end
# Whether they are these commands and nothing else.
function __lacuna_only
    set -l words (commandline -opc | string match -v -- '-*')[2..-1]
    test "$words" = "$argv"
end
complete -c lacuna -f
)sh";

/// In single quotes of fish, where a backslash makes a quote and itself.
std::string fish_word(const std::string& text) {
  std::string word = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') word += '\\';
    word += c;
  }
  return word + "'";
}

/// What a value is completed with, as options of `complete`.
std::string fish_values(Offered offered, const CommandFacts& program) {
  switch (offered) {
    case Offered::nothing: return "";
    case Offered::files: return " -F";
    case Offered::folders: return " -a '(__fish_complete_directories)'";
    case Offered::commands: return " -a " + fish_word(fmt::format("{}", fmt::join(program.subcommands, " ")));
    case Offered::shells: return " -a " + fish_word(fmt::format("{}", fmt::join(completed_shells(), " ")));
    default: return " -a " + fish_word("(sh -c " + fish_word(question_for(offered)) + " sh (commandline -opc))");
  }
}

std::string fish_option(const std::string& when, const CommandFacts& command, const OptionFacts& option,
                        const CommandFacts& program) {
  const std::string values = fish_values(offered_for(command, option), program);
  if (option.positional) return values.empty() ? "" : fmt::format("complete -c lacuna -n {}{}\n", when, values);
  const bool needs_value = option.value != OptionValue::none && option.value != OptionValue::optional_file;
  return fmt::format("complete -c lacuna -n {} -l {}{} -d {}\n", when, option.name,
                     needs_value ? (values == " -F" ? " -r -F" : " -x" + values) : "", fish_word(option.description));
}

std::string fish_commands(const CommandFacts& command, const std::vector<CommandFacts>& tree) {
  std::string lines;
  for (const CommandFacts& below : tree) {
    if (!stands_below(below, command)) continue;
    lines += fmt::format("complete -c lacuna -n {} -a {} -d {}\n",
                         fish_word(fmt::format("__lacuna_only {}", fmt::join(command.words, " "))), below.words.back(),
                         fish_word(below.description));
  }
  return lines;
}

}  // namespace

std::string fish_completion(const std::vector<CommandFacts>& tree) {
  std::string script = kFishBegin;
  for (const CommandFacts& command : tree) {
    const std::string path = fmt::format("{}", fmt::join(command.words, " "));
    const std::string when = fish_word(path.empty() ? "__lacuna_only" : "__lacuna_at " + path);
    for (const OptionFacts& option : command.options) script += fish_option(when, command, option, tree.front());
    script += fish_commands(command, tree);
  }
  return script;
}

}  // namespace lacuna
