#include "command_line/usage_error.h"

#include "command_line/subcommands.h"
#include "foundation/text/problem.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace lacuna {
namespace {

struct Place {
  const CLI::App* command = nullptr;  ///< the innermost command that was named
  std::string name;                   ///< "lacuna plugins show"
  std::vector<std::string> rest;      ///< words behind its name
};

Place place_of(const CLI::App& program, int argc, char** argv) {
  Place place{&program, program.get_name(), {argv + 1, argv + argc}};
  while (!place.rest.empty()) {
    const CLI::App* next = find_subcommand(*place.command, place.rest.front());
    if (next == nullptr) break;
    place.command = next;
    place.name += " " + next->get_name();
    place.rest.erase(place.rest.begin());
  }
  return place;
}

/// "--threads" of "--threads=2".
std::string option_part(const std::string& word) { return word.substr(0, word.find('=')); }

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// A value that may be left out, as of --json, is not taken from the next word.
std::string advice_on_value(const Place& place, const std::string& word) {
  const auto found = std::find(place.rest.begin(), place.rest.end(), word);
  if (found == place.rest.end() || found == place.rest.begin()) return "";
  const std::string& before = *(found - 1);
  const bool is_option = before.starts_with("--") && before.find('=') == std::string::npos;
  const CLI::Option* option = is_option ? place.command->get_option_no_throw(before) : nullptr;
  if (option == nullptr || !option->get_option_text().starts_with("[=")) return "";
  return fmt::format("; if it belongs to {0}, write {0}={1}", before, word);
}

/// Words that neither the program nor a command took.
std::string complaint_of_extras(const Place& place, const std::vector<std::string>& extras) {
  for (const std::string& word : extras)
    if (word.starts_with('-'))
      return "there is no option " + option_part(word) + did_you_mean(option_part(word), option_names(*place.command));
  return "one argument too many: " + extras.front() + advice_on_value(place, extras.front());
}

/// All that are missing, where CLI11 names the first alone.
std::vector<std::string> missing_options(const CLI::App& command) {
  std::vector<std::string> missing;
  for (const CLI::Option* option : command.get_options())
    if (option->get_required() && option->count() == 0) missing.push_back(option->get_name());
  return missing;
}

std::string complaint(const CLI::App& program, const Place& place, const CLI::ParseError& error) {
  const std::vector<std::string> commands = subcommand_names(*place.command);
  const bool names_none = place.rest.empty() || place.rest.front().starts_with('-');
  if (!commands.empty() && !names_none)
    return "there is no command \"" + place.rest.front() + "\"" + did_you_mean(place.rest.front(), commands);
  if (!commands.empty() && place.rest.empty()) return "name a command: " + fmt::format("{}", fmt::join(commands, ", "));
  const std::vector<std::string> extras = program.remaining(true);
  std::vector<std::string> complaints;
  if (!extras.empty()) complaints.push_back(complaint_of_extras(place, extras));
  const bool lacks_something = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  const std::vector<std::string> missing = missing_options(*place.command);
  if (lacks_something && !missing.empty())
    complaints.push_back(fmt::format("{} {} required", fmt::join(missing, ", "), missing.size() == 1 ? "is" : "are"));
  else if (dynamic_cast<const CLI::ExtrasError*>(&error) == nullptr && (!lacks_something || extras.empty()))
    complaints.push_back(error.what());  // a command may have its own words for what it requires
  return fmt::format("{}", fmt::join(complaints, "; "));
}

}  // namespace

std::string usage_sentence(const CLI::App& program, const CLI::ParseError& error, int argc, char** argv) {
  const Place place = place_of(program, argc, argv);
  return place.name + ": " + complaint(program, place, error) + "; see " + place.name + " --help";
}

}  // namespace lacuna
