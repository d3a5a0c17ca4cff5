#include "measurement/column_name.h"

#include "foundation/unit.h"
#include "measurement/number_cell.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace lacuna {
namespace {

using Spelling = std::pair<std::string_view, std::string_view>;

constexpr Spelling kWholeWords[] = {
    {"sec", "s"},   {"second", "s"},       {"seconds", "s"},   {"msec", "ms"},       {"usec", "us"},
    {"deg", "deg"}, {"degree", "deg"},     {"degrees", "deg"}, {"radian", "rad"},    {"radians", "rad"},
    {"Nm", "N*m"},  {"mNm", "mN*m"},       {"Ncm", "N*cm"},    {"newton", "N"},      {"volt", "V"},
    {"volts", "V"}, {"amp", "A"},          {"amps", "A"},      {"ampere", "A"},      {"meter", "m"},
    {"metre", "m"}, {"meters", "m"},       {"metres", "m"},    {"dps", "deg/s"},     {"rps", "rev/s"},
    {"mps", "m/s"}, {"rads", "rad/s"},     {"radps", "rad/s"}, {"degps", "deg/s"},   {"Nms", "N*m*s"},
    {"RPM", "rpm"}, {"1/min", "rpm"},      {"U/min", "rpm"},   {"m/s2", "m/s^2"},    {"rad/s2", "rad/s^2"},
    {"inch", "in"}, {"inches", "in"},      {"feet", "ft"},     {"lbs", "lb"},        {"lbfin", "lbf*in"},
    {"ohm", "Ohm"}, {"Nm/rad", "N*m/rad"}, {"m/sec", "m/s"},   {"rad/sec", "rad/s"}, {"deg/sec", "deg/s"}};

constexpr Spelling kPieces[] = {{"\u00b0", "deg"}, {"\u00b2", "^2"},     {"\u00b3", "^3"}, {"\u00b7", "*"},
                                {"\u22c5", "*"},   {"\u03bc", "\u00b5"}, {"**", "^"},      {" ", ""}};

std::string replaced(std::string text, const Spelling& piece) {
  for (std::size_t at = text.find(piece.first); at != text.npos; at = text.find(piece.first, at + piece.second.size()))
    text.replace(at, piece.first.size(), piece.second);
  return text;
}

std::string known_unit(std::string_view text) {
  std::string unit(trimmed(text));
  for (const Spelling& piece : kPieces) unit = replaced(std::move(unit), piece);
  for (const auto& [spelling, symbol] : kWholeWords)
    if (unit == spelling) unit = symbol;
  return parse_unit(unit) ? unit : "";
}

struct NameAndUnit {
  std::string_view name;
  std::string unit;
};

/// "angle [deg]": the unit in brackets at the end.
NameAndUnit split_at_bracket(std::string_view name) {
  constexpr std::array<std::pair<char, char>, 3> kBrackets{{{'[', ']'}, {'(', ')'}, {'{', '}'}}};
  for (const auto& [open, close] : kBrackets) {
    const std::size_t start = name.find(open);
    if (start == name.npos || start == 0 || name.back() != close) continue;
    std::string unit = known_unit(name.substr(start + 1, name.size() - start - 2));
    if (unit.empty()) continue;
    std::string_view rest = trimmed(name.substr(0, start));
    while (rest.ends_with('_')) rest.remove_suffix(1);
    return {rest, std::move(unit)};
  }
  return {name, ""};
}

bool unmistakable(std::string_view symbol) {
  static constexpr std::string_view kOthers[] = {"h", "g", "min", "in", "1", "%"};
  return !symbol.empty() && !std::isdigit(static_cast<unsigned char>(symbol.front())) &&
         std::find(std::begin(kOthers), std::end(kOthers), symbol) == std::end(kOthers);
}

/// "s2" → "s^2"
std::string with_power(std::string_view symbol) {
  std::string text(symbol);
  if (text.size() > 1 && (text.back() == '2' || text.back() == '3')) text.insert(text.size() - 1, "^");
  return text;
}

/// "theta_dot_rad_s": the last two words make a quotient, or the last alone is a unit.
NameAndUnit split_at_underscore(std::string_view name) {
  const std::size_t last = name.rfind('_');
  if (last == name.npos || last == 0) return {name, ""};
  const std::string_view below = name.substr(last + 1);
  const std::size_t before_last = name.rfind('_', last - 1);
  if (before_last != name.npos && before_last > 0 && unmistakable(below)) {
    const std::string_view above = name.substr(before_last + 1, last - before_last - 1);
    const std::string above_unit = unmistakable(above) || above == "in" ? known_unit(above) : "";
    if (!above_unit.empty() && below.starts_with('s'))
      if (std::string unit = known_unit(above_unit + "/" + with_power(below)); !unit.empty())
        return {name.substr(0, before_last), std::move(unit)};
  }
  if (!unmistakable(below)) return {name, ""};
  std::string unit = known_unit(below);
  return {unit.empty() ? name : name.substr(0, last), std::move(unit)};
}

NameAndUnit split_name(std::string_view name) {
  name = trimmed(name);
  NameAndUnit in_brackets = split_at_bracket(name);
  return in_brackets.unit.empty() ? split_at_underscore(name) : in_brackets;
}

}  // namespace

std::string unit_of_cell(std::string_view cell) {
  cell = trimmed(cell);
  const bool bracketed =
      cell.size() > 2 && ((cell.front() == '[' && cell.back() == ']') || (cell.front() == '(' && cell.back() == ')'));
  return known_unit(bracketed ? cell.substr(1, cell.size() - 2) : cell);
}

std::string unit_in_name(std::string_view name) { return split_name(name).unit; }

std::string name_without_unit(std::string_view name) { return std::string(split_name(name).name); }

}  // namespace lacuna
