#include "config/schema/blank.h"

#include "foundation/unit.h"

#include <cstring>

namespace lacuna {
namespace {

struct Wanted {
  const char* unit;
  const char* name;
  const char* example;
};

/// Values that drafts ask for, each with an example for a small rig.
constexpr Wanted kWanted[] = {{"kg", "a mass", "0.5 kg"},
                              {"m", "a length", "-120 mm"},
                              {"kg*m^2", "a moment of inertia", "0.002 kg*m^2"},
                              {"N*m/A", "a torque per current", "0.05 N*m/A"},
                              {"N*m/V", "a torque per voltage", "0.3 N*m/V"},
                              {"N/A", "a force per current", "20 N/A"},
                              {"N/V", "a force per voltage", "35 N/V"},
                              {"N*m/rad", "a stiffness", "20 N*m/rad"},
                              {"N*m*s/rad", "a damping", "0.5 N*m*s/rad"},
                              {"N/m", "a stiffness", "2000 N/m"},
                              {"N*s/m", "a damping", "50 N*s/m"},
                              {"Ohm", "a resistance", "2 Ohm"}};

std::string behind_blank(std::string_view text) {
  text.remove_prefix(std::strlen(kBlank));
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  return std::string(text);
}

std::string wanted_text(const std::string& unit) {
  for (const Wanted& wanted : kWanted)
    if (unit == wanted.unit) return std::string(wanted.name) + " in " + unit + ", as in \"" + wanted.example + "\"";
  return "a number and its unit, as in \"2.5 " + unit + "\"";
}

}  // namespace

bool is_blank(std::string_view text) { return text.starts_with(kBlank); }

std::string blank_complaint(std::string_view text, const std::string& unit) {
  const std::string written = behind_blank(text);
  const std::string head = "is not filled in: write ";
  if (written.empty() && unit.empty())
    return head + "the unit of the column, as in \"deg\", \"mm\", \"N*m\" or \"rad/s\"";
  if (const std::string& of = written.empty() ? unit : written; parse_unit(of)) return head + wanted_text(of);
  if (!written.empty()) return head + "one of: " + written;
  return head + "a number and its unit, " + unit;
}

}  // namespace lacuna
