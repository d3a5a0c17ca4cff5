#include "foundation/text/encoding.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace lacuna {
namespace {

constexpr std::array<std::pair<std::string_view, EncodingKind>, 3> kWithModulus = {
    {{"sign_bit ", EncodingKind::sign_bit},
     {"twos_complement ", EncodingKind::twos_complement},
     {"wraps ", EncodingKind::wraps}}};

std::optional<double> number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// A number, or a power such as 2^15.
std::optional<double> modulus(std::string_view text) {
  const std::size_t hat = text.find('^');
  const std::optional<double> base = number(text.substr(0, hat));
  if (hat == std::string_view::npos || !base) return base;
  const std::optional<double> exponent = number(text.substr(hat + 1));
  if (!exponent) return std::nullopt;
  return std::pow(*base, *exponent);
}

std::string modulus_text(double value) {
  const double exponent = std::log2(value);
  return exponent >= 8.0 && exponent == std::round(exponent) ? fmt::format("2^{:.0f}", exponent)
                                                             : fmt::format("{:.17g}", value);
}

}  // namespace

std::optional<Encoding> parse_encoding(std::string_view text) {
  if (text == "auto") return Encoding{};
  if (text == "plain") return Encoding{EncodingKind::plain, 0.0};
  for (const auto& [name, kind] : kWithModulus) {
    if (!text.starts_with(name)) continue;
    const std::optional<double> value = modulus(text.substr(name.size()));
    if (value && *value > 0.0 && std::isfinite(*value)) return Encoding{kind, *value};
  }
  return std::nullopt;
}

std::string to_string(const Encoding& encoding) {
  if (encoding.kind == EncodingKind::automatic) return "auto";
  for (const auto& [name, kind] : kWithModulus)
    if (kind == encoding.kind) return std::string(name) + modulus_text(encoding.modulus);
  return "plain";
}

}  // namespace lacuna
