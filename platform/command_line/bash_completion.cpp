#include "command_line/completion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace lacuna {
namespace {

constexpr const char* kBegin = R"sh(# bash completion for lacuna, made by: lacuna completion bash
# For this shell: source <(lacuna completion bash)
)sh";

/// How an option or argument is completed is one word, which `_lacuna_offer` knows.
constexpr const char* kEnd = R"sh(
# The option whose value the word to be completed is; "" for a word that is no option's value.
_lacuna_option() {
  local before=${COMP_WORDS[COMP_CWORD - 1]} here=${COMP_WORDS[COMP_CWORD]}
  if [[ $here == "=" ]]; then
    printf '%s' "$before"
  elif [[ $before == "=" ]]; then
    printf '%s' "${COMP_WORDS[COMP_CWORD - 2]}"
  elif [[ $before == --* ]]; then
    case $(_lacuna_takes "$1" "$before") in flag | optional | "") ;; *) printf '%s' "$before" ;; esac
  elif [[ $here != -* ]]; then  # an option that takes all words up to the next one
    local i=$((COMP_CWORD - 1))
    while [[ $i -gt 0 && ${COMP_WORDS[i]} != --* ]]; do i=$((i - 1)); done
    [[ $(_lacuna_takes "$1" "${COMP_WORDS[i]}") == *+ ]] && printf '%s' "${COMP_WORDS[i]}"
  fi
}

# How many of the words from number $2 on, before the one to be completed, are arguments without an option.
_lacuna_arguments() {
  local count=0 i word
  for ((i = $2; i < COMP_CWORD; i++)); do
    word=${COMP_WORDS[i]}
    if [[ ${COMP_WORDS[i + 1]} == "=" ]]; then
      i=$((i + 2))
    elif [[ $word == --* ]]; then
      case $(_lacuna_takes "$1" "$word") in flag | optional | "") ;; *) i=$((i + 1)) ;; esac
    else
      count=$((count + 1))
    fi
  done
  printf '%s' "$count"
}

_lacuna_offer() {  # what, beginning of the word
  local IFS=$'\n'
  case $1 in
    nothing | flag) return ;;
    files | folders | rows | queries) compopt -o filenames 2>/dev/null ;;  # bash then quotes spaces
  esac
  case $1 in
    files) mapfile -t COMPREPLY < <(compgen -f -- "$2") ;;
    folders) mapfile -t COMPREPLY < <(compgen -d -- "$2") ;;
    *) mapfile -t COMPREPLY < <(compgen -W "$(_lacuna_ask "$1" "${COMP_WORDS[@]}")" -- "$2") ;;
  esac
}

_lacuna() {
  local here=$2 path= first=1 option word takes
  COMPREPLY=()
  while [[ $first -lt $COMP_CWORD ]]; do
    word=${COMP_WORDS[first]}
    [[ " $(_lacuna_commands "$path") " == *" $word "* ]] || break
    path=${path:+$path }$word
    first=$((first + 1))
  done
  option=$(_lacuna_option "$path")
  [[ $here == "=" ]] && here=
  if [[ -n $option ]]; then
    takes=$(_lacuna_takes "$path" "$option")
    takes=${takes%+}
    [[ $takes == optional ]] && takes=files
    _lacuna_offer "$takes" "$here"
  elif [[ $here == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(_lacuna_options "$path")" -- "$here")
  elif [[ -n $(_lacuna_commands "$path") ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(_lacuna_commands "$path")" -- "$here")
  else
    _lacuna_offer "$(_lacuna_argument "$path" "$(_lacuna_arguments "$path" "$first")")" "$here"
  fi
}
complete -F _lacuna lacuna
)sh";

const char* word_for(Offered offered) {
  switch (offered) {
    case Offered::files: return "files";
    case Offered::folders: return "folders";
    case Offered::commands: return "commands";
    case Offered::effects: return "effects";
    case Offered::plugins: return "plugins";
    case Offered::kinds: return "kinds";
    case Offered::rows: return "rows";
    case Offered::queries: return "queries";
    case Offered::shells: return "shells";
    default: return "nothing";
  }
}

std::string path_of(const CommandFacts& command) { return fmt::format("{}", fmt::join(command.words, " ")); }

std::string case_of(const std::string& pattern, const std::string& words) {
  return fmt::format("    {}) echo \"{}\" ;;\n", pattern, words);
}

std::string function_of(const std::string& name, const std::string& subject, const std::string& cases) {
  return fmt::format("\n{}() {{\n  case {} in\n{}  esac\n}}\n", name, subject, cases);
}

std::string options_of(const CommandFacts& command) {
  std::string words;
  for (const OptionFacts& option : command.options)
    if (!option.positional) words += (words.empty() ? "--" : " --") + option.name;
  return words;
}

std::string takes_of(const CommandFacts& command) {
  std::string cases;
  for (const OptionFacts& option : command.options) {
    if (option.positional) continue;
    const bool is_flag = option.value == OptionValue::none, is_optional = option.value == OptionValue::optional_file;
    cases +=
        case_of(fmt::format("\"{}:--{}\"", path_of(command), option.name),
                is_flag       ? std::string("flag")
                : is_optional ? std::string("optional")
                              : word_for(offered_for(command, option)) + std::string(option.takes_rest ? "+" : ""));
  }
  return cases;
}

/// The arguments without an option by their place; the last one of several values stands for all that follow.
std::string arguments_of(const CommandFacts& command) {
  std::string cases;
  int place = 0;
  for (const OptionFacts& option : command.options)
    if (option.positional)
      cases += case_of(fmt::format("\"{}:{}\"{}", path_of(command), place++,
                                   option.repeats ? fmt::format(" | \"{}:\"*", path_of(command)) : ""),
                       word_for(offered_for(command, option)));
  return cases;
}

std::string questions(const CommandFacts& program) {
  std::string cases;
  for (const Offered offered : {Offered::effects, Offered::plugins, Offered::kinds, Offered::rows, Offered::queries})
    cases += fmt::format("    {}) {} ;;\n", word_for(offered), question_for(offered));
  cases += fmt::format("    commands) printf '%s\\n' {} ;;\n", fmt::join(program.subcommands, " "));
  return cases + fmt::format("    shells) printf '%s\\n' {} ;;\n", fmt::join(completed_shells(), " "));
}

}  // namespace

std::string bash_completion(const std::vector<CommandFacts>& tree) {
  std::string commands, options, takes, arguments;
  for (const CommandFacts& command : tree) {
    const std::string path = "\"" + path_of(command) + "\"";
    if (!command.subcommands.empty()) commands += case_of(path, fmt::format("{}", fmt::join(command.subcommands, " ")));
    options += case_of(path, options_of(command));
    takes += takes_of(command);
    arguments += arguments_of(command);
  }
  return kBegin + function_of("_lacuna_commands", "$1", commands) + function_of("_lacuna_options", "$1", options) +
         function_of("_lacuna_takes", "\"$1:$2\"", takes) + function_of("_lacuna_argument", "\"$1:$2\"", arguments) +
         function_of("_lacuna_ask", "$1", questions(tree.front())) + kEnd;
}

}  // namespace lacuna
