#include "config/toml/quantity.h"

#include "config/toml/toml_node.h"

#include <lacuna/error.h>

#include <charconv>
#include <cmath>

namespace lacuna {
namespace {

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

}  // namespace

Quantity parse_quantity(std::string_view text) {
  std::string_view rest = without_blanks(text);
  if (rest.starts_with('+')) rest.remove_prefix(1);
  double number = 0.0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (error == std::errc::result_out_of_range) throw Error(toml_text(text) + " is beyond the range of a number");
  if (error != std::errc())
    throw Error(toml_text(text) + " is not a quantity; write a number and its unit, as in \"120 mm\"");
  rest = without_blanks(rest.substr(static_cast<std::size_t>(end - rest.data())));
  Quantity quantity;
  quantity.unit = rest.empty() ? "1" : std::string(rest);
  const std::optional<Unit> unit = parse_unit(quantity.unit);
  if (!unit) throw Error(toml_text(quantity.unit) + " is not a unit; known units are " + known_units());
  quantity.parsed = *unit;
  quantity.value_in_si = number * unit->to_si;
  if (std::isfinite(number) && !std::isfinite(quantity.value_in_si))
    throw Error(toml_text(text) + " is beyond the range of a number");
  return quantity;
}

}  // namespace lacuna
