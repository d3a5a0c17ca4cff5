#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lacuna {

/// How the numbers of a column were written by the device that they come from.
enum class EncodingKind {
  automatic,        ///< as the column itself shows (measurement/trials/encoding_guess.h)
  plain,            ///< a number is what it says
  sign_bit,         ///< from `modulus` on: minus what is beyond it
  twos_complement,  ///< in the upper half of `modulus`: less `modulus`
  wraps             ///< a counter that goes on from 0 at `modulus`
};

struct Encoding {
  EncodingKind kind = EncodingKind::automatic;
  double modulus = 0.0;  ///< in the unit of the column as written
  bool operator==(const Encoding&) const = default;
};

/// Reads "auto", "plain", "sign_bit 2^15", "twos_complement 65536", "wraps 360"; nothing where it is none of these.
std::optional<Encoding> parse_encoding(std::string_view text);
/// As `parse_encoding` reads it.
std::string to_string(const Encoding& encoding);

}  // namespace lacuna
