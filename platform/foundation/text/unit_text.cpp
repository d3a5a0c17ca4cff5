#include "foundation/text/unit_text.h"

#include <algorithm>
#include <array>

namespace lacuna {
namespace {

/// A character of a unit as files write it, and as people read it.
struct Spelling {
  char typed;
  std::string_view shown;
  bool is_power;
};

constexpr std::array<Spelling, 12> kSpellings = {{{'*', "·", false},
                                                  {'-', "⁻", true},
                                                  {'0', "⁰", true},
                                                  {'1', "¹", true},
                                                  {'2', "²", true},
                                                  {'3', "³", true},
                                                  {'4', "⁴", true},
                                                  {'5', "⁵", true},
                                                  {'6', "⁶", true},
                                                  {'7', "⁷", true},
                                                  {'8', "⁸", true},
                                                  {'9', "⁹", true}}};

/// How a typed character is shown, in a power or outside; null: as it is.
const Spelling* shown_for(char typed, bool in_power) {
  const auto found = std::find_if(kSpellings.begin(), kSpellings.end(),
                                  [&](const Spelling& one) { return one.typed == typed && one.is_power == in_power; });
  return found == kSpellings.end() ? nullptr : &*found;
}

/// With which shown character a text begins; null: with another one.
const Spelling* beginning_of(std::string_view text) {
  const auto found = std::find_if(kSpellings.begin(), kSpellings.end(),
                                  [&](const Spelling& one) { return text.starts_with(one.shown); });
  return found == kSpellings.end() ? nullptr : &*found;
}

}  // namespace

std::string unit_text(std::string_view unit) {
  std::string text;
  bool in_power = false;
  for (const char c : unit) {
    in_power = c == '^' || (in_power && shown_for(c, true) != nullptr);
    if (c == '^') continue;
    const Spelling* shown = shown_for(c, in_power);
    text += shown != nullptr ? shown->shown : std::string_view(&c, 1);
  }
  return text;
}

std::string unit_after_number(std::string_view unit) { return unit == "1" ? "" : " " + unit_text(unit); }

std::string typed_unit(std::string_view text) {
  std::string unit;
  bool in_power = false;
  while (!text.empty()) {
    const Spelling* shown = beginning_of(text);
    const bool is_power = shown != nullptr && shown->is_power;
    if (is_power && !in_power) unit += '^';
    in_power = is_power;
    unit += shown != nullptr ? shown->typed : text.front();
    text.remove_prefix(shown != nullptr ? shown->shown.size() : 1);
  }
  return unit;
}

}  // namespace lacuna
