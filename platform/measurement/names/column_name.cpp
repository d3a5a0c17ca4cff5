#include "measurement/names/column_name.h"

#include "foundation/unit.h"
#include "measurement/cells/number_cell.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace lacuna {
namespace {

using Spelling = std::pair<std::string_view, std::string_view>;

constexpr Spelling kWholeWords[] = {
    {"sec", "s"},      {"second", "s"},        {"seconds", "s"},    {"msec", "ms"},       {"usec", "us"},
    {"deg", "deg"},    {"degree", "deg"},      {"degrees", "deg"},  {"radian", "rad"},    {"radians", "rad"},
    {"Nm", "N*m"},     {"mNm", "mN*m"},        {"Ncm", "N*cm"},     {"newton", "N"},      {"volt", "V"},
    {"volts", "V"},    {"amp", "A"},           {"amps", "A"},       {"ampere", "A"},      {"meter", "m"},
    {"metre", "m"},    {"meters", "m"},        {"metres", "m"},     {"dps", "deg/s"},     {"rps", "rev/s"},
    {"mps", "m/s"},    {"rads", "rad/s"},      {"radps", "rad/s"},  {"degps", "deg/s"},   {"Nms", "N*m*s"},
    {"RPM", "rpm"},    {"1/min", "rpm"},       {"U/min", "rpm"},    {"m/s2", "m/s^2"},    {"rad/s2", "rad/s^2"},
    {"inch", "in"},    {"inches", "in"},       {"feet", "ft"},      {"lbs", "lb"},        {"lbfin", "lbf*in"},
    {"ohm", "Ohm"},    {"Nm/rad", "N*m/rad"},  {"m/sec", "m/s"},    {"rad/sec", "rad/s"}, {"deg/sec", "deg/s"},
    {"sek", "s"},      {"Sek", "s"},           {"Sekunden", "s"},   {"Sec", "s"},         {"Seconds", "s"},
    {"Grad", "deg"},   {"grad", "deg"},        {"Grad/s", "deg/s"}, {"grad/s", "deg/s"},  {"gradi", "deg"},
    {"grados", "deg"}, {"degr\u00e9s", "deg"}, {"Deg", "deg"},      {"Rad", "rad"},       {"Volt", "V"},
    {"Ampere", "A"},   {"Amp\u00e8re", "A"},   {"Newton", "N"},     {"Meter", "m"},       {"mA", "mA"},
    {"tr/min", "rpm"}, {"giri/min", "rpm"},    {"rev/min", "rpm"},  {"min^-1", "rpm"},    {"min-1", "rpm"},
    {"s-1", "1/s"},    {"rad*s^-1", "rad/s"},  {"m*s^-1", "m/s"},   {"N.m", "N*m"},       {"Umdr.", "rev"},
    {"turns", "rev"},  {"Umdrehungen", "rev"}, {"kgfcm", "kgf*cm"}, {"kgcm", "kgf*cm"},   {"N-m", "N*m"}};

constexpr Spelling kPieces[] = {
    {"\u00b0", "deg"},    {"\u00ba", "deg"}, {"\u00b2", "^2"}, {"\u00b3", "^3"}, {"\u207b\u00b9", "^-1"},
    {"\u207b^2", "^-2"},  {"\u00b7", "*"},   {"\u22c5", "*"},  {"\u00d7", "*"},  {"\u2219", "*"},
    {"\u03bc", "\u00b5"}, {"**", "^"},       {" ", ""}};

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
  std::string name;
  std::string unit;
};

bool unmistakable(std::string_view symbol) {
  static constexpr std::string_view kOthers[] = {"h", "g", "min", "in", "1", "%"};
  return !symbol.empty() && !std::isdigit(static_cast<unsigned char>(symbol.front())) &&
         std::find(std::begin(kOthers), std::end(kOthers), symbol) == std::end(kOthers);
}

/// "q[1]" is the second element of a list; "slip [1]" has no dimension.
bool is_index(std::string_view name, std::size_t bracket, std::string_view inside) {
  const bool is_number =
      std::all_of(inside.begin(), inside.end(), [](char c) { return std::isdigit(static_cast<unsigned char>(c)); });
  return is_number && name[bracket] == '[' && name[bracket - 1] != ' ';
}

/// "angle [deg]", "angle [deg] filtered": the unit in brackets, at the end or where it is unmistakable.
NameAndUnit split_at_bracket(std::string_view name) {
  constexpr std::array<std::pair<char, char>, 3> kBrackets{{{'[', ']'}, {'(', ')'}, {'{', '}'}}};
  for (const auto& [open, close] : kBrackets) {
    const std::size_t start = name.find(open);
    if (start == name.npos || start == 0) continue;
    const bool at_end = name.back() == close;
    const std::size_t end = at_end ? name.size() - 1 : name.find(close, start);
    if (end == name.npos) continue;
    const std::string_view inside = name.substr(start + 1, end - start - 1);
    if (is_index(name, start, inside)) continue;
    std::string unit = at_end || unmistakable(trimmed(inside)) ? known_unit(inside) : "";
    if (unit.empty()) continue;
    std::string rest(trimmed(name.substr(0, start)));
    while (rest.ends_with('_')) rest.pop_back();
    return {rest + std::string(name.substr(end + 1)), std::move(unit)};
  }
  return {std::string(name), ""};
}

/// "s2" → "s^2"
std::string with_power(std::string_view symbol) {
  std::string text(symbol);
  if (text.size() > 1 && (text.back() == '2' || text.back() == '3')) text.insert(text.size() - 1, "^");
  return text;
}

/// "theta_dot_rad_s", "speed_rad_per_s", "angle_deg_": the last two words make a quotient, or the last alone is a unit.
NameAndUnit split_at_underscore(std::string_view written) {
  std::string name(written);
  name = replaced(std::move(name), {"_per_", "_"});
  while (name.ends_with('_')) name.pop_back();
  const std::size_t last = name.rfind('_');
  if (last == name.npos || last == 0) return {std::string(written), ""};
  const std::string_view whole = name;
  const std::string_view below = whole.substr(last + 1);
  const std::size_t before_last = name.rfind('_', last - 1);
  if (before_last != name.npos && before_last > 0 && unmistakable(below)) {
    const std::string_view above = whole.substr(before_last + 1, last - before_last - 1);
    const std::string above_unit = unmistakable(above) || above == "in" ? known_unit(above) : "";
    if (!above_unit.empty() && below.starts_with('s'))
      if (std::string unit = known_unit(above_unit + "/" + with_power(below)); !unit.empty())
        return {name.substr(0, before_last), std::move(unit)};
  }
  if (!unmistakable(below)) return {std::string(written), ""};
  std::string unit = known_unit(below);
  if (unit.empty()) return {std::string(written), ""};
  return {name.substr(0, last), std::move(unit)};
}

/// "angle..deg.": as R writes "angle (deg)".
NameAndUnit split_at_dot(std::string_view written) {
  if (written.find(' ') != written.npos) return {std::string(written), ""};
  std::string name(written);
  std::replace(name.begin(), name.end(), '.', '_');
  return split_at_underscore(name);
}

/// "Motorstrom in A", "angle, deg", "t / s", "x/m" (as DIN 1313 writes it), "Position mm".
NameAndUnit split_at_word(std::string_view name) {
  constexpr std::string_view kBetween[] = {" in ", " / ", ", ", ",", " - ", " ", "/"};
  for (const std::string_view between : kBetween) {
    const std::size_t at = name.rfind(between);
    if (at == name.npos || at == 0) continue;
    const std::string_view below = trimmed(name.substr(at + between.size()));
    const bool after_space = between == " ", is_path = name.find('/') < at && between == "/";
    // A letter after a space is as likely a label, motor A; so is the end of a path, /arm/m.
    if (!unmistakable(below) || is_path || (after_space && below.size() < 2 && below != "s")) continue;
    if (std::string unit = known_unit(below); !unit.empty())
      return {std::string(trimmed(name.substr(0, at))), std::move(unit)};
  }
  return {std::string(name), ""};
}

/// "angleDeg", "timeMs"
NameAndUnit split_at_capital(std::string_view name) {
  constexpr Spelling kEndings[] = {{"RadPerSec", "rad/s"}, {"DegPerSec", "deg/s"}, {"Deg", "deg"}, {"Rad", "rad"},
                                   {"Rpm", "rpm"},         {"Millis", "ms"},       {"Ms", "ms"},   {"Mm", "mm"}};
  for (const auto& [ending, unit] : kEndings)
    if (name.size() > ending.size() && name.ends_with(ending) &&
        std::islower(static_cast<unsigned char>(name[name.size() - ending.size() - 1])))
      return {std::string(name.substr(0, name.size() - ending.size())), std::string(unit)};
  return {std::string(name), ""};
}

/// Many write Nm as nm; torques in nanometres do not exist.
void make_torque(NameAndUnit& split) {
  if (split.unit != "nm") return;
  std::string lower;
  for (const char c : split.name) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const std::string_view word : {"torque", "tau", "moment"})
    if (lower.find(word) != lower.npos) split.unit = "N*m";
}

NameAndUnit split_name(std::string_view name) {
  name = trimmed(name);
  for (const auto& split : {split_at_bracket, split_at_underscore, split_at_dot, split_at_word, split_at_capital}) {
    NameAndUnit found = split(name);
    if (found.unit.empty()) continue;
    make_torque(found);
    return found;
  }
  return {std::string(name), ""};
}

}  // namespace

std::string unit_of_cell(std::string_view cell) {
  cell = trimmed(cell);
  const bool bracketed =
      cell.size() > 2 && ((cell.front() == '[' && cell.back() == ']') || (cell.front() == '(' && cell.back() == ')'));
  return known_unit(bracketed ? cell.substr(1, cell.size() - 2) : cell);
}

std::string unit_in_name(std::string_view name) { return split_name(name).unit; }

std::string name_without_unit(std::string_view name) { return split_name(name).name; }

}  // namespace lacuna
