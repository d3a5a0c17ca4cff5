#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lacuna {

/// How a device encoded the numbers of a column.
enum class EncodingKind {
  automatic,        ///< found from the column (measurement/trials/encoding_guess.h)
  plain,            ///< plain numbers
  sign_bit,         ///< from `modulus` on: minus the part beyond it
  twos_complement,  ///< in the upper half of `modulus`: minus `modulus`
  wraps             ///< a counter that restarts from 0 at `modulus`
};

struct Encoding {
  EncodingKind kind = EncodingKind::automatic;
  double modulus = 0.0;  ///< in the unit of the column as written
  bool operator==(const Encoding&) const = default;
};

/// Reads "auto", "plain", "sign_bit 2^15", "twos_complement 65536", "wraps 360"; nothing where it is none of these.
std::optional<Encoding> parse_encoding(std::string_view text);
/// The inverse of `parse_encoding`.
std::string to_string(const Encoding& encoding);

}  // namespace lacuna
