#include "foundation/unit.h"

#include "foundation/text/unit_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace lacuna {
namespace {

struct NamedUnit {
  std::string_view symbol;
  double to_si;
  std::array<int, 4> exponents;  // m, kg, s, A
  bool takes_prefix;
  bool angle = false;
};

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kPound = 0.45359237;  // kg
constexpr double kGravity = 9.80665;   // m/s², standard
constexpr NamedUnit kUnits[] = {
    {"1", 1.0, {0, 0, 0, 0}, false},
    {"%", 0.01, {0, 0, 0, 0}, false},
    {"rad", 1.0, {0, 0, 0, 0}, true, true},
    {"deg", kDegree, {0, 0, 0, 0}, false, true},
    {"rev", 2.0 * std::numbers::pi, {0, 0, 0, 0}, false, true},
    {"rpm", 2.0 * std::numbers::pi / 60.0, {0, 0, -1, 0}, false},
    {"min", 60.0, {0, 0, 1, 0}, false},
    {"h", 3600.0, {0, 0, 1, 0}, false},
    {"kg", 1.0, {0, 1, 0, 0}, false},
    {"g", 1e-3, {0, 1, 0, 0}, true},
    {"m", 1.0, {1, 0, 0, 0}, true},
    {"in", 0.0254, {1, 0, 0, 0}, false},
    {"ft", 0.3048, {1, 0, 0, 0}, false},
    {"lb", kPound, {0, 1, 0, 0}, false},
    {"oz", kPound / 16.0, {0, 1, 0, 0}, false},
    {"lbf", kPound* kGravity, {1, 1, -2, 0}, false},
    {"ozf", kPound* kGravity / 16.0, {1, 1, -2, 0}, false},
    {"kip", 1e3 * kPound* kGravity, {1, 1, -2, 0}, false},
    {"kgf", kGravity, {1, 1, -2, 0}, false},
    {"psi", kPound* kGravity / (0.0254 * 0.0254), {-1, 1, -2, 0}, false},
    {"s", 1.0, {0, 0, 1, 0}, true},
    {"A", 1.0, {0, 0, 0, 1}, true},
    {"N", 1.0, {1, 1, -2, 0}, true},
    {"V", 1.0, {2, 1, -3, -1}, true},
    {"W", 1.0, {2, 1, -3, 0}, true},
    {"J", 1.0, {2, 1, -2, 0}, true},
    {"Pa", 1.0, {-1, 1, -2, 0}, true},
    {"Hz", 1.0, {0, 0, -1, 0}, true},
    {"Ohm", 1.0, {2, 1, -3, -2}, true},
};

struct Prefix {
  std::string_view symbol;
  double factor;
};
constexpr Prefix kPrefixes[] = {{"k", 1e3},  {"M", 1e6},       {"c", 1e-2}, {"m", 1e-3},
                                {"u", 1e-6}, {"\u00b5", 1e-6}, {"n", 1e-9}};

std::optional<Unit> parse_symbol(std::string_view symbol) {
  for (const NamedUnit& unit : kUnits)
    if (symbol == unit.symbol) return Unit{unit.to_si, unit.exponents, unit.angle};
  for (const Prefix& prefix : kPrefixes)
    for (const NamedUnit& unit : kUnits)
      if (unit.takes_prefix && symbol.starts_with(prefix.symbol) && symbol.substr(prefix.symbol.size()) == unit.symbol)
        return Unit{unit.to_si * prefix.factor, unit.exponents, unit.angle};
  return std::nullopt;
}

/// product := factor (('*' | '/') factor)*, factor := (symbol | '(' product ')') ('^' integer)?
class UnitParser {
 public:
  explicit UnitParser(std::string_view text) : rest_(text) {}

  std::optional<Unit> parse() {
    std::optional<Unit> unit = product(0);
    return rest_.empty() ? unit : std::nullopt;
  }

 private:
  static constexpr int kDeepest = 8;

  std::optional<Unit> product(int depth) {
    std::optional<Unit> total = factor(depth);
    while (total && !rest_.empty() && (rest_.front() == '*' || rest_.front() == '/')) {
      const int sign = rest_.front() == '*' ? 1 : -1;
      rest_.remove_prefix(1);
      const std::optional<Unit> next = factor(depth);
      if (!next) return std::nullopt;
      total = combined(*total, *next, sign);
    }
    return total;
  }

  std::optional<Unit> factor(int depth) {
    std::optional<Unit> base;
    if (!rest_.empty() && rest_.front() == '(') {
      if (depth >= kDeepest) return std::nullopt;
      rest_.remove_prefix(1);
      base = product(depth + 1);
      if (!base || rest_.empty() || rest_.front() != ')') return std::nullopt;
      rest_.remove_prefix(1);
    } else {
      const std::size_t length = std::min(rest_.find_first_of("*/^()"), rest_.size());
      base = parse_symbol(rest_.substr(0, length));
      rest_.remove_prefix(length);
    }
    if (!base || rest_.empty() || rest_.front() != '^') return base;
    rest_.remove_prefix(1);
    return raised(*base);
  }

  std::optional<Unit> raised(const Unit& base) {
    const bool negative = rest_.starts_with('-');
    if (negative) rest_.remove_prefix(1);
    if (rest_.empty() || !std::isdigit(static_cast<unsigned char>(rest_.front()))) return std::nullopt;
    const int exponent = rest_.front() - '0';
    rest_.remove_prefix(1);
    Unit power;
    for (int i = 0; i < exponent; ++i) power = combined(power, base, negative ? -1 : 1);
    return power;
  }

  static Unit combined(Unit a, const Unit& b, int sign) {
    a.to_si *= sign > 0 ? b.to_si : 1.0 / b.to_si;
    a.angle = false;
    for (std::size_t i = 0; i < a.exponents.size(); ++i) a.exponents[i] += sign * b.exponents[i];
    return a;
  }

  std::string_view rest_;
};

bool takes_prefix(const std::string& unit) {
  // The prefix belongs to the first symbol; units with squares and grams get none, because they would need special
  // care.
  static constexpr std::string_view kLeading[] = {"rad", "m", "s", "N", "V", "A", "W", "J"};
  const std::string first = unit.substr(0, unit.find_first_of("*/^"));
  const bool raised = unit.size() > first.size() && unit[first.size()] == '^';
  return !raised && std::find(std::begin(kLeading), std::end(kLeading), first) != std::end(kLeading);
}

/// What a number is multiplied by before it is printed, and what is printed behind it.
struct Scaling {
  double factor = 1.0;
  std::string unit;
};

Scaling scaling_for(double magnitude, const std::string& unit) {
  const auto with = [&](double factor, const char* prefix) {
    return Scaling{factor, unit == "1" ? "" : std::string(" ") + prefix + unit_text(unit)};
  };
  if (!takes_prefix(unit) || magnitude == 0.0 || !std::isfinite(magnitude)) return with(1.0, "");
  if (magnitude < 1e-6) return with(1e9, "n");
  if (magnitude < 1e-3) return with(1e6, "\u00b5");
  if (magnitude < 0.1) return with(1e3, "m");
  if (magnitude >= 1e4) return with(1e-3, "k");
  return with(1.0, "");
}

std::string number_text(double value, int digits) {
  const double magnitude = std::abs(value);
  const int before =
      magnitude > 0.0 && std::isfinite(magnitude) ? static_cast<int>(std::floor(std::log10(magnitude))) + 1 : 1;
  return before > digits + 3 || before < -3 ? fmt::format("{:.{}g}", value, digits)
                                            : fmt::format("{:.{}f}", value, std::max(digits - before, 0));
}

}  // namespace

std::optional<Unit> parse_unit(std::string_view text) { return UnitParser(typed_unit(text)).parse(); }

std::string known_units() {
  return "m, mm, cm, in, ft, rad, mrad, deg, rev, s, ms, min, kg, g, lb, oz, N, mN, lbf, kip, kgf, ozf, psi, Pa, V, "
         "mV, A, "
         "mA, Hz, rpm, 1, % and products such as N*m, kg*m^2, N*m*s/rad, lbf*in";
}

std::string format_quantity(double value_in_si, const std::string& unit, int digits) {
  const Scaling scaling = scaling_for(std::abs(value_in_si), unit);
  return number_text(value_in_si * scaling.factor, digits) + scaling.unit;
}

std::string format_change(double before_in_si, double after_in_si, const std::string& unit, int digits) {
  const Scaling scaling = scaling_for(std::max(std::abs(before_in_si), std::abs(after_in_si)), unit);
  return fmt::format("{} → {}{}", number_text(before_in_si * scaling.factor, digits),
                     number_text(after_in_si * scaling.factor, digits), scaling.unit);
}

}  // namespace lacuna
