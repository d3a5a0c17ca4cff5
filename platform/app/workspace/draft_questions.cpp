#include "app/workspace/draft_questions.h"

#include "config/toml/quantity.h"
#include "config/toml/toml_node.h"
#include "foundation/text/plain_text.h"
#include "foundation/unit.h"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <optional>
#include <sstream>
#include <vector>

namespace lacuna {
namespace {

/// A blank of a draft, and where it stands.
struct DraftBlank {
  std::string section, key, comment;
  std::string wanted;          ///< "kg", "world or arm"; empty: the unit of a column
  std::string channel_unit;    ///< of a column: what its channel has
  std::string column;          ///< whose unit it is
  std::string default_answer;  ///< empty: none
};

const MatchedColumn* match_of(const RigDraft& draft, const DraftBlank& blank) {
  const bool is_command = blank.section == "[target.commands]";
  if (!is_command && blank.section != "[target.sensors]") return nullptr;
  const std::vector<MatchedColumn>& matches = is_command ? draft.guess.commands : draft.guess.sensors;
  const auto found = std::ranges::find_if(
      matches, [&](const MatchedColumn& match) { return toml_key(match.channel.name) == blank.key; });
  return found == matches.end() ? nullptr : &*found;
}

std::string question(const DraftBlank& blank) {
  std::string text = fmt::format("{} {}: ", blank.section, blank.key);
  if (!blank.column.empty()) return text + fmt::format("the unit of column {}", blank.column);
  text += parse_unit(blank.wanted) ? "a number in " + blank.wanted : blank.wanted;
  return blank.comment.empty() ? text : text + " (" + blank.comment + ")";
}

/// What to put between the quotes; nothing, with a reason, where the answer cannot be.
std::optional<std::string> accepted(const DraftBlank& blank, const std::string& answer, std::string& reason) {
  try {
    if (!blank.column.empty()) {
      const std::optional<Unit> unit = parse_unit(answer), channel = parse_unit(blank.channel_unit);
      if (unit && channel && unit->same_dimension(*channel)) return answer;
      reason = unit ? fmt::format("the channel is in {}; a column in {} needs a gain, so write both in the file",
                                  blank.channel_unit, answer)
                    : "known units are " + known_units();
      return std::nullopt;
    }
    if (const std::optional<Unit> unit = parse_unit(blank.wanted)) {
      const Quantity quantity = parse_quantity(answer);
      if (quantity.unit == "1") return answer + " " + blank.wanted;
      if (quantity.parsed.same_dimension(*unit)) return answer;
      reason = "the unit must be " + blank.wanted;
      return std::nullopt;
    }
  } catch (const Error& error) {
    reason = error.what();
    return std::nullopt;
  }
  std::istringstream words(blank.wanted);
  for (std::string word; words >> word;)
    if (word == answer && word != "or") return answer;
  reason = "write one of: " + blank.wanted;
  return std::nullopt;
}

/// The answer, the default, or nothing: the blank stays.
std::optional<std::string> answer_to(const DraftBlank& blank, std::istream& in, std::ostream& out) {
  std::string line;
  while (true) {
    out << plain_text(question(blank)) << " [" << (blank.default_answer.empty() ? "leave blank" : blank.default_answer)
        << "]: " << std::flush;
    if (!std::getline(in, line)) {
      out << "\n";
      return std::nullopt;
    }
    const std::size_t first = line.find_first_not_of(" \t\r"), last = line.find_last_not_of(" \t\r");
    if (first == std::string::npos)
      return blank.default_answer.empty() ? std::nullopt : std::optional(blank.default_answer);
    std::string reason;
    if (auto taken = accepted(blank, line.substr(first, last - first + 1), reason)) return taken;
    out << "  " << plain_text(reason) << "\n";
  }
}

/// What a line of a draft says of the blanks in it.
DraftBlank blank_in(const RigDraft& draft, const std::string& section, const std::string& line) {
  DraftBlank blank;
  blank.section = section;
  blank.key = line.substr(0, line.find_first_of(" ="));
  if (const std::size_t comment = line.find("  # "); comment != std::string::npos)
    blank.comment = line.substr(comment + 4);
  if (const MatchedColumn* match = match_of(draft, blank)) {
    blank.column = match->column.name;
    blank.channel_unit = match->channel.unit;
  }
  return blank;
}

/// "[2]" of the third of a list; empty: the line has none.
std::string place_in_list(const std::string& line, std::size_t at) {
  const std::size_t start = line.find(" = [");
  if (start == std::string::npos || start > at) return "";
  return fmt::format("[{}]", std::count(line.begin() + static_cast<std::ptrdiff_t>(start),
                                        line.begin() + static_cast<std::ptrdiff_t>(at), ','));
}

/// The blanks of one line, one after the other.
std::string line_with_answers(const RigDraft& draft, const std::string& section, std::string line, std::istream& in,
                              std::ostream& out) {
  const std::string open = '"' + std::string(kBlank);
  for (std::size_t at = line.find(open); at != std::string::npos && in; at = line.find(open, at + 1)) {
    const std::size_t end = line.find('"', at + 1);
    DraftBlank blank = blank_in(draft, section, line);
    blank.key += place_in_list(line, at);
    blank.wanted = line.substr(at + open.size(), end - at - open.size());
    blank.wanted.erase(0, blank.wanted.find_first_not_of(' '));
    if (!blank.wanted.empty()) blank.column.clear();  // a gain
    if (blank.wanted.empty()) blank.default_answer = blank.channel_unit;
    if (blank.wanted.empty() && blank.column.empty()) continue;
    if (const auto answer = answer_to(blank, in, out)) line.replace(at + 1, end - at - 1, *answer);
  }
  return line;
}

}  // namespace

bool asks_at_terminal() { return ::isatty(STDIN_FILENO) == 1 && ::isatty(STDOUT_FILENO) == 1; }

std::string with_answers(const RigDraft& draft, const std::string& name, const std::string& text, std::istream& in,
                         std::ostream& out) {
  std::istringstream lines(text);
  std::string all, section, line;
  bool is_said = false;
  while (std::getline(lines, line)) {
    if (line.starts_with('[')) section = line.substr(0, line.find("]") + 1);
    const bool has_blank = in && !line.starts_with('#') && line.find('"' + std::string(kBlank)) != std::string::npos;
    if (has_blank && !is_said) out << plain_text(name) << ": press Enter to take the value in brackets\n";
    is_said = is_said || has_blank;
    all += (has_blank ? line_with_answers(draft, section, line, in, out) : line) + "\n";
  }
  return all;
}

void ask_for_blanks(const RigDraft& draft, std::string& experiment, std::string& robot) {
  experiment = with_answers(draft, draft.experiment.string(), experiment, std::cin, std::cout);
  if (!robot.empty()) robot = with_answers(draft, draft.robot.string(), robot, std::cin, std::cout);
}

}  // namespace lacuna
