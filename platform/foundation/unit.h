#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace lacuna {

/// A unit of measurement: its factor to SI and its dimension.
struct Unit {
  double to_si = 1.0;              ///< value in SI = value in this unit × to_si
  std::array<int, 4> exponents{};  ///< of m, kg, s, A; angles have none
  bool angle = false;              ///< rad, deg, rev by themselves: not shares of 1, unlike `%`
  bool same_dimension(const Unit& other) const { return exponents == other.exponents && angle == other.angle; }
};

/// Reads units such as `rad`, `deg`, `mm`, `N*m`, `kg*m^2`, `N*m*s/rad`, `m/s^2`, `ms`, `V`, `N/V`, `1`, `%`, and those
/// that `unit_text` writes, such as `N·m`. Nothing if the text is not a unit.
std::optional<Unit> parse_unit(std::string_view text);

/// Examples of units for messages "known units are ...".
std::string known_units();

/// A number with its unit, as people read it, and a suitable SI prefix: 0.0091 rad → "9.10 mrad", 0.0315 N*m*s/rad →
/// "31.5 mN·m·s/rad". `digits`: significant digits.
std::string format_quantity(double value_in_si, const std::string& unit, int digits = 3);

/// Two values of one quantity with one prefix, that of the larger: "7.85 → 0.391 mN·m·s/rad".
std::string format_change(double before_in_si, double after_in_si, const std::string& unit, int digits = 3);

}  // namespace lacuna
